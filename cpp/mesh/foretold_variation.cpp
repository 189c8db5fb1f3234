// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/foretold_variation.hpp"

#include <algorithm>

namespace fgmesh {
namespace {

// A quadratic f has f(p) = sum l_i (f_i + g_i . (p - p_i) / 2) for p = sum l_i p_i: the mean of the slopes at
// both ends of the way from each corner, where those at p cancel each other.

/// Of two constituents: the range over the corners, the extremes along the edges and the middles of the
/// faces.
double foretold_range(const std::array<const Vertex*, 4>& corners) {
  double low = 1.0, high = 0.0;
  const auto include = [&](double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const Vertex* corner : corners) include(corner->own.composition[0]);
  double bends[4][4];  // of the edge from i to j: half of g_i . (p_j - p_i)
  for (const auto& [i, j] : kEdgeVertices) {
    const MaterialValue &at_i = corners[i]->own, &at_j = corners[j]->own;
    const Vec3 way = corners[j]->position - corners[i]->position;
    bends[i][j] = 0.5 * at_i.gradient[0].dot(way);
    bends[j][i] = -0.5 * at_j.gradient[0].dot(way);
    const double from = at_i.composition[0], change = at_j.composition[0] - from;
    // f = from + t change + t (1 - t) bend
    const double bend = bends[i][j] + bends[j][i];
    if (std::abs(bend) <= std::abs(change)) continue;
    const double t = 0.5 + 0.5 * change / bend;
    include(from + t * change + t * (1.0 - t) * bend);
  }
  for (const auto& face : kFaceVertices) {
    double middle = 0.0;
    for (int k = 0; k < 3; ++k) {
      const int i = face[k], j = face[(k + 1) % 3];
      middle += corners[i]->own.composition[0] / 3.0 + (bends[i][j] + bends[j][i]) / 9.0;
    }
    include(middle);
  }
  return std::max(0.0, std::min(high, 1.0) - std::max(low, 0.0));
}

/// Of more: the largest difference between corners and middles of edges.
double foretold_distance(const std::array<const Vertex*, 4>& corners) {
  // As Composition, but without asking for memory.
  using Parts = boost::container::small_vector<double, 7>;
  std::array<Parts, 10> values;
  for (int i = 0; i < 4; ++i)
    values[i].assign(corners[i]->own.composition.begin(), corners[i]->own.composition.end());
  for (int e = 0; e < 6; ++e) {
    const auto& [i, j] = kEdgeVertices[e];
    const Vec3 way = corners[j]->position - corners[i]->position;
    for (std::size_t c = 0; c < values[i].size(); ++c)
      values[4 + e].push_back(
          std::clamp(0.5 * (values[i][c] + values[j][c]) +
                         0.125 * (corners[i]->own.gradient[c] - corners[j]->own.gradient[c]).dot(way),
                     0.0, 1.0));
  }
  double largest = 0.0;
  for (int i = 1; i < 10; ++i)
    for (int j = 0; j < i; ++j) largest = std::max(largest, squared_difference(values[i], values[j]));
  return std::sqrt(largest);
}

}  // namespace

double foretold_variation(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  const std::array<const Vertex*, 4> corners{&a, &b, &c, &d};
  for (const Vertex* corner : corners)
    if (!corner->others.empty()) return variation(a, b, c, d);
  return a.own.composition.size() == 1 ? foretold_range(corners) : foretold_distance(corners);
}

}  // namespace fgmesh
