// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/composition.hpp"
#include "core/composition_field.hpp"

namespace fgmesh {

enum class Proof {
  kProved,   ///< nowhere in the tetrahedron does the composition vary by more than the threshold
  kBroken,   ///< two points in it differ by more
  kUnproved  ///< neither was found with as many pieces as were allowed
};

/// What is known of the variation over the whole of a tetrahedron, its inside as well as its corners.
struct TetCertificate {
  Proof proof = Proof::kUnproved;
  double bound = 0.0;           ///< the variation is certainly not above this
  std::array<Vec3, 2> apart{};  ///< the two points known to differ most
  double variation = 0.0;       ///< by this
  int pieces = 0;               ///< into how many the tetrahedron was divided, over which f was bounded
};

/// What the comparison with a threshold leaves to rounding, as a part of the threshold.
inline constexpr double kCertificateRounding = 1e-9;

/// Bounds the variation of the composition over a tetrahedron by branch and bound: pieces of it, halved at
/// their longest edge where the bound is worst, until it is below the threshold, two points are found that
/// differ by more, or there are `most_pieces`. `at_corners`: the fractions there. Fractions count as clamped
/// to [0, 1]; places where they are not defined (outside the solid) count nothing.
TetCertificate certify_tet(const CompositionField& field, const Corners& tet,
                           const std::array<Composition, 4>& at_corners, double threshold, int most_pieces);

}  // namespace fgmesh
