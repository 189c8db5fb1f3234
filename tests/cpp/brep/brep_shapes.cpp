// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep_shapes.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <BOPAlgo_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

namespace fgmesh::test {

TopoDS_Shape box(double x, double y, double z) { return BRepPrimAPI_MakeBox(x, y, z).Shape(); }

TopoDS_Shape box_with_hole() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-30, -20, -15), gp_Pnt(30, 20, 15)).Shape();
  const gp_Ax2 axis(gp_Pnt(15, 0, -20), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeCylinder(axis, 8, 40).Shape()).Shape();
}

TopoDS_Shape filleted_box() {
  const TopoDS_Shape block = box(40, 30, 20);
  BRepFilletAPI_MakeFillet fillet(block);
  fillet.Add(5.0, TopoDS::Edge(TopExp_Explorer(block, TopAbs_EDGE).Current()));
  return fillet.Shape();
}

TopoDS_Shape spline_prism() {
  constexpr int count = 12;
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count, radius = 10.0 + 2.0 * std::cos(3.0 * angle);
    points->SetValue(i + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0.0));
  }
  GeomAPI_Interpolate interpolate(points, Standard_True, 1e-9);
  interpolate.Perform();
  const TopoDS_Wire wire =
      BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(interpolate.Curve()).Edge()).Wire();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, 15)).Shape();
}

TopoDS_Shape teardrop() {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = poles(4) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(30, 10, 0);
  poles(3) = gp_Pnt(30, -10, 0);
  const Handle(Geom_BezierCurve) loop = new Geom_BezierCurve(poles);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(loop).Edge()).Wire();
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, 8)).Shape();
}

TopoDS_Shape thin_tube(double outer_radius, double inner_radius, double height) {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(outer_radius, height).Shape(),
                         BRepPrimAPI_MakeCylinder(inner_radius, height).Shape())
      .Shape();
}

TopoDS_Shape two_joined_boxes() {
  BOPAlgo_Builder fragments;
  fragments.AddArgument(box(10, 10, 10));
  fragments.AddArgument(BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), gp_Pnt(20, 10, 10)).Shape());
  fragments.Perform();
  return fragments.Shape();
}

std::vector<KnownSolid> known_solids() {
  return {
      {"box", box(10, 20, 30), 6000.0, 2},
      {"ball", BRepPrimAPI_MakeSphere(50).Shape(), 4.0 / 3.0 * M_PI * 125000.0, 2},
      {"cylinder", BRepPrimAPI_MakeCylinder(20, 60).Shape(), M_PI * 400.0 * 60.0, 2},
      {"cone with a tip", BRepPrimAPI_MakeCone(10, 0, 25).Shape(), M_PI * 100.0 * 25.0 / 3.0, 2},
      {"half a cone with a tip", BRepPrimAPI_MakeCone(10, 0, 25, M_PI).Shape(), M_PI * 50.0 * 25.0 / 3.0, 2},
      {"cone without a tip", BRepPrimAPI_MakeCone(10, 5, 12).Shape(), M_PI * 12.0 / 3.0 * (100 + 50 + 25), 2},
      {"torus", BRepPrimAPI_MakeTorus(30, 8).Shape(), 2.0 * M_PI * M_PI * 30.0 * 64.0, 0},
      {"box with a hole", box_with_hole(), 72000.0 - M_PI * 64.0 * 30.0, 0},
      {"box with a fillet", filleted_box(), 24000.0 - (1.0 - M_PI / 4.0) * 25.0 * 20.0, 2},
  };
}

std::string brep_text(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

std::string step_text(const std::vector<TopoDS_Shape>& roots) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Writer writer;
  for (const TopoDS_Shape& root : roots) writer.Transfer(root, STEPControl_AsIs);
  // OpenCASCADE 7.6 writes STEP to files only.
  const std::string path = testing::TempDir() + "fgmesh_brep_" + std::to_string(getpid()) + ".step";
  writer.Write(path.c_str());
  std::ifstream file(path);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  std::remove(path.c_str());
  return text;
}

BrepModel read(const TopoDS_Shape& shape) {
  RunControl control;
  return BrepModel::from_text(brep_text(shape), control);
}

std::pair<BrepModel, SampledBoundary> sampled(const TopoDS_Shape& shape, const SamplingOptions& options) {
  RunControl control;
  BrepModel model = read(shape);
  SampledBoundary boundary = model.sample(options, control);
  return {std::move(model), std::move(boundary)};
}

}  // namespace fgmesh::test
