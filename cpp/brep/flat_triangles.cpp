// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/flat_triangles.hpp"

#include <algorithm>
#include <vector>

namespace fgmesh::brep {
namespace {

using Triangle = std::array<int, 3>;

/// Height over the longest side, as a share of that side; `longest` is the corner opposite to it.
double flatness(const std::vector<Vec3>& points, const Triangle& triangle, int& longest) {
  double longest2 = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double length2 = (points[triangle[(k + 1) % 3]] - points[triangle[(k + 2) % 3]]).squaredNorm();
    if (length2 <= longest2) continue;
    longest2 = length2;
    longest = k;
  }
  const Vec3& a = points[triangle[0]];
  const double doubled_area = (points[triangle[1]] - a).cross(points[triangle[2]] - a).norm();
  return longest2 > 0.0 ? doubled_area / longest2 : 0.0;
}

// Ten thousand times above rounding, and far below the height of any triangle that is meant.
constexpr double flat = 1e-9;

bool is_flat(const SampledBoundary& boundary, std::size_t triangle) {
  int longest = 0;
  return flatness(boundary.points, boundary.triangles[triangle], longest) < flat;
}

/// The triangle of the same face that runs from `from` to `to`, and its third corner; -1 where there is none.
int neighbour(const SampledBoundary& boundary, const std::vector<std::vector<int>>& around, int face,
              int from, int to, int& apex) {
  for (const int other : around[from]) {
    if (boundary.triangle_face[other] != face) continue;
    const Triangle& t = boundary.triangles[other];
    for (int k = 0; k < 3; ++k) {
      if (t[k] != from || t[(k + 1) % 3] != to) continue;
      apex = t[(k + 2) % 3];
      return other;
    }
  }
  return -1;
}

void replace(SampledBoundary& boundary, std::vector<std::vector<int>>& around, int index,
             const Triangle& by) {
  for (const int point : boundary.triangles[index]) {
    auto& list = around[point];
    list.erase(std::remove(list.begin(), list.end(), index), list.end());
  }
  boundary.triangles[index] = by;
  for (const int point : by) around[point].push_back(index);
}

bool flip(SampledBoundary& boundary, std::vector<std::vector<int>>& around, int index) {
  const Triangle t = boundary.triangles[index];
  int k = 0;
  flatness(boundary.points, t, k);
  const int middle = t[k], from = t[(k + 1) % 3], to = t[(k + 2) % 3];
  int apex = -1;
  const int other = neighbour(boundary, around, boundary.triangle_face[index], to, from, apex);
  if (other < 0 || apex == middle || is_flat(boundary, other)) return false;
  replace(boundary, around, index, {middle, from, apex});
  replace(boundary, around, other, {middle, apex, to});
  return true;
}

}  // namespace

void flip_flat_triangles(SampledBoundary& boundary) {
  std::vector<int> waiting;
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    if (is_flat(boundary, i)) waiting.push_back(static_cast<int>(i));
  }
  if (waiting.empty()) return;
  std::vector<std::vector<int>> around(boundary.points.size());
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    for (const int point : boundary.triangles[i]) around[point].push_back(static_cast<int>(i));
  }
  // A flat triangle beside a flat one waits until that has been flipped.
  for (std::size_t before = waiting.size() + 1; !waiting.empty() && waiting.size() < before;) {
    before = waiting.size();
    waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                                 [&](int index) { return flip(boundary, around, index); }),
                  waiting.end());
  }
}

}  // namespace fgmesh::brep
