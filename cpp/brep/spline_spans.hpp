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
  std::vector<double> u_knots_, v_knots_;  ///< inner ones
  std::vector<Handle(BSplSLib_Cache)> spans_;
};

}  // namespace fgmesh::brep
