// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include "core/composition.hpp"
#include "core/composition_field.hpp"

namespace fgmesh {

/// A part of a tetrahedron with what is known of the composition in it.
struct TetPiece {
  Corners corners;
  std::array<Composition, 4> values;          ///< at the corners, clamped to [0, 1]; NaN where not defined
  Composition low, high;                      ///< bounds of each fraction over all of the piece
  CompositionGradient slope_low, slope_high;  ///< and of their slopes, 1/mm

  bool knows_corners() const;
  double longest_edge_squared() const;
};

/// The corners among which a function that is known at all four is extreme: bit i for corner i.
using CornerSet = unsigned;
inline constexpr CornerSet kAllCorners = 15;
inline bool holds(CornerSet set, int corner) { return (set >> corner) & 1u; }
inline bool is_single(CornerSet set) { return (set & (set - 1)) == 0; }

/// The corners that remain for the largest value of a function whose slopes lie between `low` and `high`: a
/// corner drops out where the way from it to another leads nowhere down. Among the least ones for the slopes
/// of the function with its sign turned.
CornerSet highest_corners(const Corners& corners, const Vec3& slope_low, const Vec3& slope_high);

/// How far a function with such slopes can be from its interpolation between the corners of the set: a
/// quarter of the sum over the axes of the side of their box times the slope's width. Infinite where a slope
/// is.
///
/// For p = sum l_i p_i, f(p) - sum l_i f(p_i) = sum l_i s_i . (p - p_i); the middle of the slopes gives
/// nothing, and the mean distance along an axis from the mean of points is at most half of their range.
double nonlinearity(const Corners& corners, CornerSet set, const Vec3& slope_low, const Vec3& slope_high);

/// The whole tetrahedron.
TetPiece whole_piece(const CompositionField& field, const Corners& tet,
                     const std::array<Composition, 4>& at_corners);

/// Both halves of a piece, and the point between them: that in the middle of its longest edge.
struct Halves {
  std::array<TetPiece, 2> piece;
  Vec3 middle;
  Composition value;
};
Halves halved(const CompositionField& field, const TetPiece& piece);

}  // namespace fgmesh
