// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/spline_spans.hpp"

#include <TColStd_Array1OfReal.hxx>
#include <algorithm>

namespace fgmesh::brep {
namespace {

std::vector<double> inner_knots(const TColStd_Array1OfReal& knots) {
  return {&knots(knots.Lower() + 1), &knots(knots.Upper())};
}

/// Middles of the spans between the knots.
std::vector<double> middles(const TColStd_Array1OfReal& knots) {
  std::vector<double> found;
  for (int i = knots.Lower(); i < knots.Upper(); ++i) found.push_back(0.5 * (knots(i) + knots(i + 1)));
  return found;
}

std::size_t span(const std::vector<double>& inner_knots, double parameter) {
  return std::upper_bound(inner_knots.begin(), inner_knots.end(), parameter) - inner_knots.begin();
}

}  // namespace

SplineSpans::SplineSpans(const Geom_BSplineSurface& surface)
    : u_knots_(inner_knots(surface.UKnots())), v_knots_(inner_knots(surface.VKnots())) {
  const TColStd_Array1OfReal &u_flat = surface.UKnotSequence(), &v_flat = surface.VKnotSequence();
  for (const double u : middles(surface.UKnots())) {
    for (const double v : middles(surface.VKnots())) {
      const Handle(BSplSLib_Cache) cache =
          new BSplSLib_Cache(surface.UDegree(), surface.IsUPeriodic(), u_flat, surface.VDegree(),
                             surface.IsVPeriodic(), v_flat, surface.Weights());
      cache->BuildCache(u, v, u_flat, v_flat, surface.Poles(), surface.Weights());
      spans_.push_back(cache);
    }
  }
}

const BSplSLib_Cache& SplineSpans::at(double u, double v) const {
  return *spans_[span(u_knots_, u) * (v_knots_.size() + 1) + span(v_knots_, v)];
}

}  // namespace fgmesh::brep
