// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "core/boundary_geometry.hpp"

namespace fgmesh {

/// How long the segments along creases may be: the size asked for, less where a curve bends, and less where a
/// crease that it does not touch runs close by, so that protecting balls stay smaller than a wall between two
/// creases.
class CreaseSizing {
 public:
  CreaseSizing(const SampledBoundary& samples, double size);

  /// At a point of the curve (its position in SampledBoundary::curves), mm.
  double on_curve(int curve, const Vec3& p) const;

  /// At the corner with exactly these coordinates: the least of its curves, mm.
  double at_corner(const Vec3& p) const;

 private:
  void limit_by_curvature();
  void limit_by_distance();
  void limit_growth();

  const SampledBoundary& samples_;
  std::vector<std::vector<double>> size_;  // of each sample point of each curve
  std::map<std::array<double, 3>, double> corner_size_;
  double largest_;
};

}  // namespace fgmesh
