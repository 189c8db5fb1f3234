// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/tet_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The least that a slope between `low` and `high` makes of a way.
double least_change(const Vec3& low, const Vec3& high, const Vec3& way) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    if (way[axis] != 0.0) sum += (way[axis] > 0.0 ? low[axis] : high[axis]) * way[axis];
  return sum;
}

/// Fills the bounds of a piece: those that its slopes allow about the corners, those of the field, and those
/// of the piece that it is part of, whichever are tighter.
void find_bounds(const CompositionField& field, TetPiece& piece, const TetPiece* parent) {
  const std::size_t count = piece.values[0].size();
  piece.low.resize(count);
  piece.high.resize(count);
  piece.slope_low.resize(count);
  piece.slope_high.resize(count);
  field.tet_bounds(piece.corners, piece.low.data(), piece.high.data(), piece.slope_low.data(),
                   piece.slope_high.data());
  const bool known = piece.knows_corners();
  for (std::size_t c = 0; c < count; ++c) {
    Vec3 &down = piece.slope_low[c], &up = piece.slope_high[c];
    double low = std::isnan(piece.low[c]) ? -kInfinity : piece.low[c];
    double high = std::isnan(piece.high[c]) ? kInfinity : piece.high[c];
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isnan(down[axis])) down[axis] = -kInfinity;
      if (std::isnan(up[axis])) up[axis] = kInfinity;
    }
    if (known) {
      const CornerSet highest = highest_corners(piece.corners, down, up);
      const CornerSet lowest = highest_corners(piece.corners, -up, -down);
      double most = -kInfinity, least = kInfinity;
      for (int i = 0; i < 4; ++i) {
        if (holds(highest, i)) most = std::max(most, piece.values[i][c]);
        if (holds(lowest, i)) least = std::min(least, piece.values[i][c]);
      }
      high = std::min(high, most + nonlinearity(piece.corners, highest, down, up));
      low = std::max(low, least - nonlinearity(piece.corners, lowest, down, up));
    }
    piece.low[c] = std::clamp(low, parent ? parent->low[c] : 0.0, 1.0);
    piece.high[c] = std::clamp(high, 0.0, parent ? parent->high[c] : 1.0);
  }
}

/// The edge along which the slopes are known worst: halved it tightens the bounds most. The longest where
/// they are not known at all.
std::array<int, 2> edge_to_halve(const TetPiece& piece) {
  Vec3 width = Vec3::Zero();
  for (std::size_t c = 0; c < piece.slope_low.size(); ++c) width += piece.slope_high[c] - piece.slope_low[c];
  if (!width.allFinite() || width.isZero()) width.setOnes();
  std::array<int, 2> edge = {0, 1};
  double most = -1.0;
  for (const auto& [i, j] : kEdgeVertices) {
    const double gain = (piece.corners[i] - piece.corners[j]).cwiseAbs().dot(width);
    if (gain <= most) continue;
    most = gain;
    edge = {i, j};
  }
  return edge;
}

}  // namespace

bool TetPiece::knows_corners() const {
  for (const Composition& value : values)
    for (const double part : value)
      if (std::isnan(part)) return false;
  return true;
}

double TetPiece::longest_edge_squared() const {
  double longest = 0.0;
  for (const auto& [i, j] : kEdgeVertices)
    longest = std::max(longest, (corners[i] - corners[j]).squaredNorm());
  return longest;
}

CornerSet highest_corners(const Corners& corners, const Vec3& slope_low, const Vec3& slope_high) {
  CornerSet left = kAllCorners;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4 && holds(left, i); ++j)
      if (j != i && holds(left, j) && least_change(slope_low, slope_high, corners[j] - corners[i]) >= 0.0)
        left &= ~(1u << i);
  return left;
}

double nonlinearity(const Corners& corners, CornerSet set, const Vec3& slope_low, const Vec3& slope_high) {
  if (is_single(set)) return 0.0;
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    double low = kInfinity, high = -kInfinity;
    for (int i = 0; i < 4; ++i) {
      if (!holds(set, i)) continue;
      low = std::min(low, corners[i][axis]);
      high = std::max(high, corners[i][axis]);
    }
    if (high > low) sum += (high - low) * (slope_high[axis] - slope_low[axis]);
  }
  return 0.25 * sum;
}

TetPiece whole_piece(const CompositionField& field, const Corners& tet,
                     const std::array<Composition, 4>& at_corners) {
  TetPiece piece;
  piece.corners = tet;
  piece.values = at_corners;
  for (Composition& value : piece.values)
    for (double& part : value) part = std::isnan(part) ? part : std::clamp(part, 0.0, 1.0);
  find_bounds(field, piece, nullptr);
  return piece;
}

Halves halved(const CompositionField& field, const TetPiece& piece) {
  const auto [a, b] = edge_to_halve(piece);
  Halves result;
  result.middle = 0.5 * (piece.corners[a] + piece.corners[b]);
  result.value.resize(piece.values[0].size());
  field.evaluate(&result.middle, 1, result.value.data());
  for (double& part : result.value) part = std::isnan(part) ? part : std::clamp(part, 0.0, 1.0);
  for (const int replaced : {a, b}) {
    TetPiece& half = result.piece[replaced == a ? 0 : 1];
    half.corners = piece.corners;
    half.values = piece.values;
    half.corners[replaced] = result.middle;
    half.values[replaced] = result.value;
    find_bounds(field, half, &piece);
  }
  return result;
}

}  // namespace fgmesh
