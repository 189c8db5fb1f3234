// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/vec3.hpp"

namespace fgmesh {

/// A function of position with an exact gradient.
/// Members are const and may be called from several threads at once.
class ScalarField {
 public:
  virtual ~ScalarField() = default;

  /// values[i] = f(points[i]); NaN where f is not defined. Never throws.
  virtual void evaluate(const Vec3* points, std::size_t count, double* values) const = 0;

  /// As evaluate(), with the gradient (1/mm). Where f is finite the gradient has no NaN: at a point where it
  /// is not unique (d at O) it is zero in the undefined part; where it is unbounded it may be infinite.
  virtual void evaluate(const Vec3* points, std::size_t count, double* values, Vec3* gradients) const = 0;

  /// Certain bounds of f over a box: f lies within [low, high] wherever it is defined there.
  virtual void bounds(const Box& box, double& low, double& high) const = 0;

  /// The same over a tetrahedron.
  virtual void tet_bounds(const Corners& tet, double& low, double& high) const {
    bounds(box_around(tet), low, high);
  }
};

}  // namespace fgmesh
