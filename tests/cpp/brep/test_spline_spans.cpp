// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/spline_spans.hpp"

#include <gtest/gtest.h>
#include <GeomConvert.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Ax3.hxx>

#include <random>

namespace fgmesh {
namespace {

/// A torus as a B-spline that is periodic in both directions.
Handle(Geom_BSplineSurface) torus() {
  return GeomConvert::SurfaceToBSplineSurface(new Geom_ToroidalSurface(gp_Ax3(), 7.0, 2.0));
}

void expect_same_as(const Geom_BSplineSurface& surface, double margin) {
  const brep::SplineSpans spans(surface);
  double u_low = 0.0, u_high = 0.0, v_low = 0.0, v_high = 0.0;
  surface.Bounds(u_low, u_high, v_low, v_high);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> part(-margin, 1.0 + margin);
  for (int i = 0; i < 2000; ++i) {
    const double u = u_low + part(generator) * (u_high - u_low);
    const double v = v_low + part(generator) * (v_high - v_low);
    gp_Pnt found;
    spans.at(u, v).D0(u, v, found);
    ASSERT_LT(found.Distance(surface.Value(u, v)), 1e-10) << u << ", " << v;
  }
}

TEST(SplineSpans, AreTheSurfaceBetweenItsKnots) {
  const Handle(Geom_BSplineSurface) spline = torus();
  spline->SetUNotPeriodic();
  spline->SetVNotPeriodic();
  expect_same_as(*spline, 0.0);
}

TEST(SplineSpans, GoOnWithAPeriodicSurface) {
  const Handle(Geom_BSplineSurface) spline = torus();
  ASSERT_TRUE(spline->IsUPeriodic() && spline->IsVPeriodic());
  expect_same_as(*spline, 1.5);
}

TEST(SplineSpans, TakeTheFirstKnotLessARoundingError) {
  const Handle(Geom_BSplineSurface) spline = torus();
  const brep::SplineSpans spans(*spline);
  const double u = spline->UKnot(1) - 1e-6, v = spline->VKnot(1) - 1e-6;
  gp_Pnt found;
  spans.at(u, v).D0(u, v, found);
  EXPECT_LT(found.Distance(gp_Pnt(9.0, 0.0, 0.0)), 1e-4);
}

}  // namespace
}  // namespace fgmesh
