// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/formula_names.hpp"
#include "material/material.hpp"

namespace fgmesh {

/// x y z r theta d of points in a material's frame, and their gradients in the world's.
class FrameCoordinates {
 public:
  FrameCoordinates(const Frame& frame, const Vec3* points) : frame_(frame), points_(points) {}

  /// As PointInputs has them, for coordinates alone.
  void values(Variable variable, std::size_t first, std::size_t count, double* out) const;

  /// Where the direction is not unique the gradient is zero: that of d at the origin, of r and theta on the
  /// axis.
  void duals(Variable variable, std::size_t first, std::size_t count, std::size_t stride, double* out) const;

 private:
  const Frame& frame_;
  const Vec3* points_;
};

/// What the coordinate `variable` can be within a box of the world.
Interval coordinate_bounds(const Frame& frame, const Box& box, Variable variable);

/// The same with its slopes along the world's axes; everything where theta jumps.
DualInterval coordinate_dual_bounds(const Frame& frame, const Box& box, Variable variable);

}  // namespace fgmesh
