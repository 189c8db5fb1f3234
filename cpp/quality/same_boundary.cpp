// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/same_boundary.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace fgmesh {
namespace {

using Side = std::array<int, 2>;

/// How the elements of one face or edge hang together.
struct Pieces {
  int count = 0;
  int euler = 0;  ///< vertices less sides plus triangles

  bool operator==(const Pieces& other) const { return count == other.count && euler == other.euler; }
};

/// Of triangles, or of segments where `triangles` is 0.
Pieces pieces_of(std::vector<Side> sides, int triangles) {
  for (Side& side : sides) std::sort(side.begin(), side.end());
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::vector<int> vertices;
  for (const Side& side : sides) vertices.insert(vertices.end(), side.begin(), side.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  std::vector<int> root(vertices.size());
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&](int vertex) {
    int i = static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  int count = static_cast<int>(vertices.size());
  const int euler = count - static_cast<int>(sides.size()) + triangles;
  for (const auto& [a, b] : sides) {
    const int from = root_of(a), to = root_of(b);
    count -= from != to;
    root[from] = to;
  }
  return {count, euler};
}

/// Of each face; `faces` holds the FaceN of each triangle.
template <class Triangle, class Number>
std::vector<Pieces> pieces_of_faces(const std::vector<Triangle>& triangles, const std::vector<Number>& faces,
                                    int face_count) {
  std::vector<std::vector<Side>> sides(face_count);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    sides[faces[t] - 1].insert(sides[faces[t] - 1].end(), {{a, b}, {b, c}, {c, a}});
  }
  std::vector<Pieces> pieces;
  for (std::vector<Side>& own : sides) {
    const int count = static_cast<int>(own.size() / 3);
    pieces.push_back(pieces_of(std::move(own), count));
  }
  return pieces;
}

std::string told(const std::string& name, const Pieces& found, const Pieces& expected) {
  if (found.count == 0) return name + " has no elements";
  if (found.count != expected.count)
    return name + " is in " + std::to_string(found.count) + " pieces where the shape has " +
           std::to_string(expected.count);
  return name + " has other holes or handles than in the shape (Euler characteristic " +
         std::to_string(found.euler) + " for " + std::to_string(expected.euler) + ")";
}

/// Two faces that have a side in common inside both: nothing is left between them there. One twice, where it
/// touches itself; {0, 0} where no faces do.
template <class IsBridged>
Side touching_faces(const TetMesh& mesh, const IsBridged& is_bridged) {
  std::vector<std::array<int, 3>> sides;  // the ends, and FaceN
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const int face = mesh.triangle_faces[t];
    if (is_bridged(2, face)) continue;
    for (const auto& [from, to] : {Side{a, b}, Side{b, c}, Side{c, a}})
      sides.push_back({std::min(from, to), std::max(from, to), face});
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Side> edges;
  for (const auto& [a, b] : mesh.edges) edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 3; i < sides.size(); ++i) {
    const auto& [a, b, face] = sides[i - 3];
    const int other = sides[i][2];
    const bool same_side = sides[i][0] == a && sides[i][1] == b;
    if (same_side && sides[i - 2][2] == face && sides[i - 1][2] == other &&
        !std::binary_search(edges.begin(), edges.end(), Side{a, b}))
      return {face, other};
  }
  return {0, 0};
}

}  // namespace

std::string find_difference(const TetMesh& mesh, const SampledBoundary& samples,
                            const std::vector<Carrier>& bridged, const PartName& name) {
  const auto is_bridged = [&](int dimension, int number) {
    return std::any_of(bridged.begin(), bridged.end(), [&](const Carrier& part) {
      return part.dimension == dimension && part.number == number;
    });
  };
  const std::vector<Pieces> found = pieces_of_faces(mesh.triangles, mesh.triangle_faces, samples.face_count),
                            expected =
                                pieces_of_faces(samples.triangles, samples.triangle_face, samples.face_count);
  for (int face = 1; face <= samples.face_count; ++face)
    if (!(found[face - 1] == expected[face - 1]) && !is_bridged(2, face))
      return told(name({2, face}), found[face - 1], expected[face - 1]);

  std::vector<std::array<int, 3>> segments;  // EdgeN and its ends
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    segments.push_back({mesh.edge_edges[i], mesh.edges[i][0], mesh.edges[i][1]});
  std::sort(segments.begin(), segments.end());
  for (const SampledBoundary::Curve& curve : samples.curves) {
    std::vector<Side> own, sampled;
    for (auto it = std::lower_bound(segments.begin(), segments.end(), std::array{curve.edge, -1, -1});
         it != segments.end() && (*it)[0] == curve.edge; ++it)
      own.push_back({(*it)[1], (*it)[2]});
    for (std::size_t i = 1; i < curve.points.size(); ++i)
      sampled.push_back({curve.points[i - 1], curve.points[i]});
    const Pieces in_mesh = pieces_of(own, 0), in_shape = pieces_of(sampled, 0);
    if (!(in_mesh == in_shape) && !is_bridged(1, curve.edge))
      return told(name({1, curve.edge}), in_mesh, in_shape);
  }
  if (const auto [face, other] = touching_faces(mesh, is_bridged); face)
    return name({2, face}) + " and " + name({2, other}) +
           " touch, where the shape has a wall or a gap between them";
  return {};
}

}  // namespace fgmesh
