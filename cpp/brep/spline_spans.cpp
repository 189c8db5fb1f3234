// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/spline_spans.hpp"

#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <cmath>

namespace fgmesh::brep {
namespace {

/// Middles of the spans between the knots.
std::vector<double> middles(const TColStd_Array1OfReal& knots) {
  std::vector<double> found;
  for (int i = knots.Lower(); i < knots.Upper(); ++i) found.push_back(0.5 * (knots(i) + knots(i + 1)));
  return found;
}

}  // namespace

SplineSpans::Direction::Direction(const TColStd_Array1OfReal& knots, bool is_periodic)
    : inner(&knots(knots.Lower() + 1), &knots(knots.Upper())),
      low(knots.First()),
      high(knots.Last()),
      periodic(is_periodic) {}

std::size_t SplineSpans::Direction::span(double parameter) const {
  // As OpenCASCADE does before it evaluates.
  if (periodic && (parameter < low || parameter > high))
    parameter -= (high - low) * std::floor((parameter - low) / (high - low));
  return std::upper_bound(inner.begin(), inner.end(), parameter) - inner.begin();
}

SplineSpans::SplineSpans(const Geom_BSplineSurface& surface)
    : u_(surface.UKnots(), surface.IsUPeriodic()), v_(surface.VKnots(), surface.IsVPeriodic()) {
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
  return *spans_[u_.span(u) * (v_.inner.size() + 1) + v_.span(v)];
}

}  // namespace fgmesh::brep
