// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/small_features.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace fgmesh {
namespace {

class Bridging {
 public:
  Bridging(SurfaceMesh& mesh, double size) : mesh_(mesh), size_(size) {}

  /// Returns whether anything was bridged.
  bool pass(RunControl& control) {
    bool changed = false;
    const std::size_t old_triangles = mesh_.triangles.size();  // new ones wait, so that this ends on any face
    for (std::size_t t = 0; t < old_triangles; ++t) {
      if (t % 1024 == 0) control.check();
      if (mesh_.triangles[t].alive() && altitude(mesh_.triangles[t]) < size_)
        changed = bridge(static_cast<int>(t)) || changed;
    }
    return changed;
  }

  /// Marks the vertices where edges meet that are none of theirs.
  void mark_junctions() {
    for (const auto& [key, edge] : mesh_.creases()) {
      for (int v : SurfaceMesh::ends(key)) {
        Vertex& vertex = mesh_.vertices[v];
        vertex.junction = vertex.junction || (vertex.carrier.dimension == 1 && vertex.carrier.number != edge);
      }
    }
  }

  std::vector<Carrier> touched() const {
    std::vector<Carrier> parts;
    for (const auto& [dimension, number] : touched_) parts.push_back({dimension, number});
    return parts;
  }

 private:
  double length(int a, int b) const { return (mesh_.position(a) - mesh_.position(b)).norm(); }

  Vec3 area(const SurfaceTriangle& triangle) const {
    const auto& [a, b, c] = triangle.vertex;
    return area_vector(mesh_.position(a), mesh_.position(b), mesh_.position(c));
  }

  /// The triangle's vertices, those of its longest edge first.
  std::array<int, 3> from_longest(const SurfaceTriangle& triangle) const {
    std::array<int, 3> v = triangle.vertex;
    for (int turn = 0; turn < 2; ++turn)
      if (length(v[0], v[1]) < std::max(length(v[1], v[2]), length(v[2], v[0])))
        std::rotate(v.begin(), v.begin() + 1, v.end());
    return v;
  }

  double altitude(const SurfaceTriangle& triangle) const {
    const std::array<int, 3> v = from_longest(triangle);
    const double longest = length(v[0], v[1]);
    return longest > 0.0 ? area(triangle).norm() / longest : 0.0;
  }

  /// The short edge of a needle, or the altitude of a triangle that is flat at its apex.
  bool bridge(int t) {
    const std::array<int, 3> v = from_longest(mesh_.triangles[t]);
    const int near = length(v[2], v[0]) < length(v[2], v[1]) ? v[0] : v[1];
    if (length(v[2], near) < size_) return merge(v[2], near) || merge(near, v[2]);
    const Carrier& apex = mesh_.vertices[v[2]].carrier;
    const int edge = mesh_.crease(v[0], v[1]);
    if (apex.dimension == 1 && apex.number == edge) return false;
    if (!edge) return apex.dimension < 2 && exchange_longest(v);
    if (is_wall(v[2], {v[0], v[1]})) return false;
    const int foot = mesh_.split(v[0], v[1], mesh_.position(v[2]));
    // A vertex inside a face goes onto an edge of the shape: merge() lets none leave its edge.
    return foot >= 0 && (merge(foot, v[2]) || merge(v[2], foot));
  }

  /// Exchanges the edge from v[0] to v[1], the longest, inside a narrow face, for one across it. Each makes
  /// edges shorter, so that this ends.
  bool exchange_longest(const std::array<int, 3>& v) {
    std::vector<int> around;
    mesh_.at_edge(v[0], v[1], around);
    for (int t : around)
      if (const int beyond = mesh_.triangles[t].apex(v[0], v[1]); beyond != v[2])
        return length(v[2], beyond) < length(v[0], v[1]) && mesh_.exchange(v[0], v[1]);
    return false;
  }

  bool merge(int v, int w) {
    const Carrier old = mesh_.vertices[v].carrier;
    drawn_.resize(mesh_.vertices.size(), 0.0);
    const double drawn = drawn_[v] + length(v, w);
    if (old.dimension < mesh_.vertices[w].carrier.dimension || drawn >= size_ || is_wall(v, {w}))
      return false;
    std::set<std::pair<int, int>> parts = {{old.dimension, old.number}};
    for (int t : mesh_.at(v)) {
      if (mesh_.triangles[t].has(w) ? part_between(mesh_.triangles[t].apex(v, w), v, w) : folds(t, v, w))
        return false;
      parts.insert({2, mesh_.triangles[t].face});
      for (int p : mesh_.triangles[t].vertex)
        if (const int edge = p == v ? 0 : mesh_.crease(v, p)) parts.insert({1, edge});
    }
    if (!mesh_.merge(v, w)) return false;
    touched_.insert(parts.begin(), parts.end());
    drawn_[w] = std::max(drawn_[w], drawn);
    return true;
  }

  /// Whether the edges of the shape from a vertex to two others, which are to become one, are farther from
  /// each other on the way than at those.
  bool part_between(int from, int v, int w) const {
    const int first = mesh_.crease(from, v), second = mesh_.crease(from, w);
    if (!first || !second || first == second) return false;
    const BoundaryGeometry& boundary = mesh_.state().boundary();
    for (const double s : {0.25, 0.5, 0.75}) {
      const Vec3 place = mesh_.position(from) + s * (mesh_.position(v) - mesh_.position(from));
      const Vec3 on_first = boundary.project_to_edge(first, place).position;
      if ((boundary.project_to_edge(second, on_first).position - on_first).norm() >= size_) return true;
    }
    return false;
  }

  /// Whether triangle t turns over where v goes to w; narrow ones are going to vanish.
  bool folds(int t, int v, int w) const {
    constexpr double kLeastCosine = 0.5;
    const SurfaceTriangle& triangle = mesh_.triangles[t];
    if (altitude(triangle) < size_) return false;
    SurfaceTriangle moved = triangle;
    std::replace(moved.vertex.begin(), moved.vertex.end(), v, w);
    const Vec3 before = area(triangle), after = area(moved);
    return !(before.dot(after) > kLeastCosine * before.norm() * after.norm());
  }

  /// Whether the two sides of a wall would come together: faces at v, and at another vertex or edge, that
  /// look away from each other. At the end of a wedge they may. Also where the two are not of the same
  /// solids.
  bool is_wall(int v, const std::vector<int>& other) {
    constexpr double kOpposite = -0.996;  // cosine; a wedge of 5 degrees
    std::vector<int> beside;
    for (int t : mesh_.at(other.front()))
      if (mesh_.triangles[t].has(other.back())) beside.push_back(t);
    const int near = length(v, other.back()) < length(v, other.front()) ? other.back() : other.front();
    const std::vector<Vec3> normals = normals_at(v, mesh_.at(v));
    for (const Vec3& normal : normals_at(near, beside))
      for (const Vec3& own : normals)
        if (own.dot(normal) < kOpposite) return true;
    return solids_of(mesh_.at(v)) != solids_of(beside);
  }

  std::set<std::array<int, 2>> solids_of(const std::vector<int>& triangles) const {
    std::set<std::array<int, 2>> solids;
    for (int t : triangles) solids.insert(mesh_.triangles[t].solid);
    return solids;
  }

  /// Of the true faces, since narrow triangles may have turned over; right at the vertex, since on a bent
  /// wall normals beside it differ by as much as those of a wedge.
  std::vector<Vec3> normals_at(int v, const std::vector<int>& triangles) {
    std::set<int> faces;
    for (int t : triangles) faces.insert(mesh_.triangles[t].face);
    std::vector<Vec3> normals;
    for (int face : faces) {
      const auto [known, is_new] = normals_.try_emplace({v, face});
      // Asked once, since OpenCASCADE is slow to tell in sharp corners.
      if (is_new) known->second = mesh_.state().boundary().project_to_face(face, mesh_.position(v)).normal;
      normals.push_back(known->second);
    }
    return normals;
  }

  SurfaceMesh& mesh_;
  double size_;
  std::vector<double> drawn_;                    // how far what has become a vertex was from it
  std::set<std::pair<int, int>> touched_;        // dimension and number
  std::map<std::pair<int, int>, Vec3> normals_;  // of vertex and face
};

}  // namespace

std::vector<Carrier> bridge_small_features(SurfaceMesh& mesh, double size, RunControl& control) {
  constexpr int kMostPasses = 20;
  Bridging bridging(mesh, size);
  for (int pass = 0; pass < kMostPasses && bridging.pass(control); ++pass) {
  }
  bridging.mark_junctions();
  return bridging.touched();
}

}  // namespace fgmesh
