// SPDX-License-Identifier: GPL-3.0-or-later
#include "occt_shapes.hpp"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepTools.hxx>
#include <TopoDS_Shape.hxx>
#include <sstream>

namespace fgmesh::test {
namespace {

std::string text_of(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

}  // namespace

std::string box_text(double x, double y, double z) { return text_of(BRepPrimAPI_MakeBox(x, y, z).Shape()); }

std::string ball_text(double radius) { return text_of(BRepPrimAPI_MakeSphere(radius).Shape()); }

std::string cylinder_text(double radius, double height) {
  return text_of(BRepPrimAPI_MakeCylinder(radius, height).Shape());
}

}  // namespace fgmesh::test
