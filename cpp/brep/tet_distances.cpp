// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/tet_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fgmesh::brep {
namespace {

/// Of the squares of distances d_i at the corners of a tetrahedron, the least that the squared distance to
/// any set has inside: |p|^2 - d(p)^2 is the largest of linear functions, so it is convex, and nowhere above
/// its interpolation from the corners. Corners drop out that it falls away from.
double least_squared(const Corners& tet, const std::array<double, 4>& distances) {
  std::array<Vec3, 4> at;
  std::array<double, 4> gap{};
  for (int i = 0; i < 4; ++i) {
    at[i] = tet[i] - tet[0];
    gap[i] = at[i].squaredNorm() - distances[i] * distances[i];
  }
  // |p|^2 less the interpolation: half its slope along the edge from i to j, at its smallest.
  const auto rises = [&](int i, int j) {
    const Vec3 way = at[j] - at[i];
    const double least = std::min({at[0].dot(way), at[1].dot(way), at[2].dot(way), at[3].dot(way)});
    return least >= 0.5 * (gap[j] - gap[i]);
  };
  std::array<bool, 4> dropped{};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4 && !dropped[j]; ++i) dropped[j] = i != j && !dropped[i] && rises(i, j);
  double least = std::numeric_limits<double>::infinity(), longest = 0.0;
  int left = 0;
  for (int i = 0; i < 4; ++i) {
    if (dropped[i]) continue;
    ++left;
    least = std::min(least, distances[i] * distances[i]);
    for (int j = 0; j < i; ++j)
      if (!dropped[j]) longest = std::max(longest, (at[i] - at[j]).squaredNorm());
  }
  return least - 0.5 * (1.0 - 1.0 / left) * longest;
}

double farthest(const Corners& tet, const Vec3& from) {
  double squared = 0.0;
  for (const Vec3& corner : tet) squared = std::max(squared, (corner - from).squaredNorm());
  return std::sqrt(squared);
}

}  // namespace

DistanceBounds bounds_between(const Corners& tet, const CornerDistances& corners, double close,
                              bool is_signed, double margin) {
  std::array<double, 4> distances{};
  // Upper bounds of the distance, and bounds of that with a sign by the ways from the corners.
  double most = std::numeric_limits<double>::infinity(), above = most, below = -most;
  for (int i = 0; i < 4; ++i) {
    const double value = corners.values[i];
    distances[i] = std::abs(value);
    const double reach = farthest(tet, tet[i]);
    above = std::min(above, value + reach);
    below = std::max(below, value - reach);
    most = std::min(most, distances[i] + reach);
    // No point of the tetrahedron is farther from the reference than from the point of it nearest to a
    // corner.
    if (distances[i] > close) most = std::min(most, farthest(tet, tet[i] - value * corners.gradients[i]));
  }
  const double least = std::sqrt(std::max(0.0, least_squared(tet, distances)));
  if (!is_signed) return {std::max(0.0, std::max(least, below) - margin), most + margin};
  if (least > margin) {  // so clear of the boundary that it is on one side
    if (corners.values[0] < 0.0) return {-most - margin, std::min(-least, above) + margin};
    return {std::max(least, below) - margin, most + margin};
  }
  return {std::max(-most, below) - margin, std::min(most, above) + margin};
}

}  // namespace fgmesh::brep
