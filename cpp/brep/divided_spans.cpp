// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/divided_spans.hpp"

#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace fgmesh::brep {
namespace {

constexpr int few_knots = 8, parts = 8;

TColStd_Array1OfReal divided(const TColStd_Array1OfReal& knots) {
  TColStd_Array1OfReal all(1, parts * (knots.Length() - 1) + 1);
  int next = 1;
  for (int i = knots.Lower(); i < knots.Upper(); ++i)
    for (int part = 0; part < parts; ++part)
      all(next++) = knots(i) + part * (knots(i + 1) - knots(i)) / parts;
  all(next) = knots(knots.Upper());
  return all;
}

/// Full ones: only by such knots BRepMesh takes spans to be parted.
TColStd_Array1OfInteger multiplicities(const TColStd_Array1OfReal& knots, int degree) {
  TColStd_Array1OfInteger all(knots.Lower(), knots.Upper());
  all.Init(degree);
  return all;
}

}  // namespace

void divide_spans(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const Handle(Geom_BSplineSurface) spline =
        Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces(i))));
    if (spline.IsNull()) continue;
    const double same = Precision::PConfusion();
    if (spline->NbUKnots() <= few_knots) {
      const TColStd_Array1OfReal knots = divided(spline->UKnots());
      spline->InsertUKnots(knots, multiplicities(knots, spline->UDegree()), same, Standard_False);
    }
    if (spline->NbVKnots() <= few_knots) {
      const TColStd_Array1OfReal knots = divided(spline->VKnots());
      spline->InsertVKnots(knots, multiplicities(knots, spline->VDegree()), same, Standard_False);
    }
  }
}

}  // namespace fgmesh::brep
