// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/vec3.hpp"

namespace fgmesh {

/// Volume fractions of k constituents as functions f_1 ... f_k-1 of position with exact gradients, the last
/// being the remainder: what the mesh stages know of a material. Of n points, arrays hold f_1 at all of them,
/// then f_2, and so on: (k - 1) n entries.
///
/// Members are const and may be called from several threads at once.
class CompositionField {
 public:
  virtual ~CompositionField() = default;

  /// k, at least 2.
  virtual int constituents() const = 0;

  /// The fractions at the points; NaN where one is not defined. Never throws.
  virtual void evaluate(const Vec3* points, std::size_t count, double* fractions) const = 0;

  /// As evaluate(), with gradients (1/mm), as ScalarField has them.
  virtual void evaluate(const Vec3* points, std::size_t count, double* fractions, Vec3* gradients) const = 0;

  /// Certain bounds of f_1 ... f_k-1 over a box.
  virtual void bounds(const Box& box, double* low, double* high) const = 0;

  /// Certain bounds of f_1 ... f_k-1 over a tetrahedron, and of their slopes (1/mm): wherever f is defined,
  /// f(p) - f(q) = s . (p - q) for an s between slope_low and slope_high. They are infinite where f may jump
  /// or its slope explodes. NaN where f is defined nowhere.
  virtual void tet_bounds(const Corners& tet, double* low, double* high, Vec3* slope_low,
                          Vec3* slope_high) const = 0;
};

}  // namespace fgmesh
