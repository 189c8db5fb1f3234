// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/curved_tets.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <numeric>

#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

/// Derivatives of the position along the three edges at corner 0, at each of the four corners of a part of
/// the tetrahedron; they are linear between the corners.
using Slopes = std::array<Eigen::Matrix<double, 3, 4>, 3>;

Slopes slopes_of(const CurvedTet& nodes) {
  // Control points of the quadratic: the corners, and where the tangents at the ends of an edge meet.
  Vec3 control[4][4];
  for (int i = 0; i < 4; ++i) control[i][i] = nodes[i];
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = kMiddleEdges[e];
    control[i][j] = control[j][i] = 2.0 * nodes[4 + e] - 0.5 * (nodes[i] + nodes[j]);
  }
  Slopes slopes;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 4; ++i) slopes[k].col(i) = 2.0 * (control[k + 1][i] - control[0][i]);
  return slopes;
}

/// Coefficients over the part of the tetrahedron that `s` stands for: the polar form of the determinant,
/// which is the mean over all orders of three corners.
std::array<double, 20> coefficients(const Slopes& s) {
  const auto det = [&](int i, int j, int k) { return s[0].col(i).cross(s[1].col(j)).dot(s[2].col(k)); };
  std::array<double, 20> result;
  auto next = result.begin();
  for (int i = 0; i < 4; ++i)
    for (int j = i; j < 4; ++j)
      for (int k = j; k < 4; ++k)
        *next++ =
            (det(i, j, k) + det(i, k, j) + det(j, i, k) + det(j, k, i) + det(k, i, j) + det(k, j, i)) / 6.0;
  return result;
}

/// Bisects until the coefficients tell, at most `depth` times.
bool proved_above(const Slopes& s, double least, int depth) {
  const std::array<double, 20> bounds = coefficients(s);
  if (*std::min_element(bounds.begin(), bounds.end()) > least) return true;
  if (depth == 0) return false;
  // Halving the edge along which the slopes differ most brings the coefficients together fastest.
  const auto difference = [&](const int* edge) {
    double sum = 0.0;
    for (const auto& slope : s) sum += (slope.col(edge[0]) - slope.col(edge[1])).squaredNorm();
    return sum;
  };
  const auto& [a, b] = *std::max_element(
      std::begin(kEdgeVertices), std::end(kEdgeVertices),
      [&](const auto& edge, const auto& other) { return difference(edge) < difference(other); });
  Slopes first = s, second = s;
  for (int k = 0; k < 3; ++k) first[k].col(b) = second[k].col(a) = 0.5 * (s[k].col(a) + s[k].col(b));
  return proved_above(first, least, depth - 1) && proved_above(second, least, depth - 1);
}

}  // namespace

CurvedTet curved_tet(const SecondOrderMesh& mesh, std::size_t tet) {
  CurvedTet nodes;
  for (int i = 0; i < 10; ++i) nodes[i] = mesh.points[mesh.tets[tet][i]];
  return nodes;
}

std::array<double, 20> jacobian_coefficients(const CurvedTet& nodes) {
  return coefficients(slopes_of(nodes));
}

bool jacobian_is_above(const CurvedTet& nodes, double least) {
  constexpr int kBisections = 9;
  const Slopes slopes = slopes_of(nodes);
  // No proof can succeed where a corner contradicts it.
  for (int i = 0; i < 4; ++i)
    if (!(slopes[0].col(i).cross(slopes[1].col(i)).dot(slopes[2].col(i)) > least)) return false;
  return proved_above(slopes, least, kBisections);
}

std::vector<double> tet_volumes(const SecondOrderMesh& mesh) {
  std::vector<double> result;
  result.reserve(mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    // All Bernstein polynomials of a degree have the same integral.
    const std::array<double, 20> jacobian = jacobian_coefficients(curved_tet(mesh, t));
    result.push_back(std::accumulate(jacobian.begin(), jacobian.end(), 0.0) / (6.0 * jacobian.size()));
  }
  return result;
}

double volume(const SecondOrderMesh& mesh) {
  const std::vector<double> volumes = tet_volumes(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

Vec3 centre_of_triangle(const SecondOrderMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c, ab, bc, ca] = mesh.triangles[triangle];
  return (4.0 * (mesh.points[ab] + mesh.points[bc] + mesh.points[ca]) -
          (mesh.points[a] + mesh.points[b] + mesh.points[c])) /
         9.0;
}

}  // namespace fgmesh
