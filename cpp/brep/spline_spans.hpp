// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BSplSLib_Cache.hxx>
#include <Geom_BSplineSurface.hxx>
#include <vector>

namespace fgmesh::brep {

/// The polynomials of a B-spline surface between its knots: several times as fast as the surface, whose every
/// evaluation makes them anew. Immutable and safe to share between threads, as OpenCASCADE's adaptors, which
/// keep the last one, are not.
class SplineSpans {
 public:
  /// Empty, until assigned.
  SplineSpans() = default;
  explicit SplineSpans(const Geom_BSplineSurface& surface);

  bool empty() const { return spans_.empty(); }
  const BSplSLib_Cache& at(double u, double v) const;

 private:
  struct Direction {
    Direction() = default;
    Direction(const TColStd_Array1OfReal& knots, bool is_periodic);
    std::size_t span(double parameter) const;

    std::vector<double> inner;  ///< knots but the first and the last
    double low = 0.0, high = 0.0;
    bool periodic = false;
  };
  Direction u_, v_;
  std::vector<Handle(BSplSLib_Cache)> spans_;
};

}  // namespace fgmesh::brep
