// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/vec3.hpp"

namespace fgmesh::brep {

/// Distances to a part of a shape at the corners of a tetrahedron, below zero inside of a solid, and their
/// gradients.
struct CornerDistances {
  std::array<double, 4> values{};
  std::array<Vec3, 4> gradients;
};

struct DistanceBounds {
  double low, high;
};

/// What the distance can be within a tetrahedron, from those at its corners; widened by `margin`. Gradients
/// point away from the nearest point where the distance is above `close`.
DistanceBounds bounds_between(const Corners& tet, const CornerDistances& corners, double close,
                              bool is_signed, double margin);

}  // namespace fgmesh::brep
