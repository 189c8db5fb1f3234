// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// A triangle of the boundary, counter-clockwise seen from outside its first solid.
struct SurfaceTriangle {
  std::array<int, 3> vertex{};
  int face = 0;                ///< FaceN; 0: this slot is free
  std::array<int, 2> solid{};  ///< SolidN behind and before it; 0: outside

  bool alive() const { return face != 0; }
  bool has(int v) const { return vertex[0] == v || vertex[1] == v || vertex[2] == v; }
  /// The vertex that is neither a nor b.
  int apex(int a, int b) const {
    for (int v : vertex)
      if (v != a && v != b) return v;
    return -1;
  }
};

/// A triangulation of the boundary of all solids whose vertices lie on the true boundary. Any number of
/// triangles may meet at an edge.
class SurfaceMesh {
 public:
  /// The samples as they are. Of `state` only the true boundary is asked.
  SurfaceMesh(const MeshState& state, const SampledBoundary& samples);

  std::vector<Vertex> vertices;  ///< values and gradients of f are not set
  std::vector<SurfaceTriangle> triangles;

  const MeshState& state() const { return state_; }
  const Vec3& position(int v) const { return vertices[v].position; }
  /// The triangles at a vertex.
  const std::vector<int>& at(int v) const { return at_[v]; }
  /// The triangles at an edge.
  void at_edge(int a, int b, std::vector<int>& found) const;
  /// EdgeN that the edge (a, b) follows; 0: none.
  int crease(int a, int b) const;
  const std::unordered_map<std::uint64_t, int>& creases() const { return creases_; }
  static std::array<int, 2> ends(std::uint64_t key) {
    return {static_cast<int>(key >> 32), static_cast<int>(key & 0xffffffffu)};
  }

  /// Of all solids, mm^3.
  double volume() const;

  /// A vertex that no triangle has yet.
  int add_vertex(const Vertex& vertex);

  /// Splits an edge by a new vertex on the true boundary, nearest to the middle of the edge or to `target`.
  /// Returns the vertex; -1, and nothing is changed, where the edge runs beside its face. An edge inside two
  /// faces is split in one of them.
  int split(int a, int b) { return split(a, b, 0.5 * (position(a) + position(b))); }
  int split(int a, int b, const Vec3& target);

  /// Splits a triangle at a vertex of other triangles that lies upon it: the surfaces meet at that point.
  void meet(int t, int v);

  /// Draws `v` onto its neighbour `w`, if triangles, creases and faces stay what they are, no edge comes
  /// farther than `chord` from its face, none longer than `longest`. Returns whether it did.
  bool collapse(int v, int w, double chord, double longest);

  /// The same with two vertices of whatever edges and faces: these lose the edges and triangles between the
  /// two, and the surface keeps its holes and handles. Nothing is asked of the triangles made.
  bool merge(int v, int w);

  /// Draws a vertex inside the face of triangle `t`, which faces inwards, onto a neighbour so that fewer of
  /// the triangles around face inwards. Samples fold like that where a face ends in a sharp corner. Returns
  /// whether it did.
  bool unfold(int t);
  /// Whether triangle `t` faces out of its first solid, as its face does there.
  bool faces_out(int t) const { return faces_out(triangles[t].vertex, triangles[t].face, 0.0); }

  /// Exchanges the edge (a, b) inside a face for the other diagonal, if the angles opposite ask for it
  /// (Delaunay) and the surface allows it. Returns whether it did.
  bool flip(int a, int b, double chord);
  /// The same whatever the triangles made. Returns false where the edge is none inside a face, or the
  /// diagonal is an edge already.
  bool exchange(int a, int b);

 private:
  /// The two triangles at an edge that may be exchanged for a diagonal, and that diagonal.
  struct Quadrilateral {
    std::array<int, 2> triangles;
    int c, d;  ///< apices of the first and the second
  };
  std::optional<Quadrilateral> quadrilateral(int a, int b) const;
  /// The triangles that the other diagonal makes.
  std::array<SurfaceTriangle, 2> exchanged(int a, int b, const Quadrilateral& quad) const;
  void replace(const Quadrilateral& quad, const std::array<SurfaceTriangle, 2>& made);
  /// What surrounds two neighbours that are to become one.
  struct Neighbours {
    std::vector<int> own;   ///< neighbours of the first, ascending
    std::vector<int> both;  ///< of both, ascending
    bool closed = true;     ///< one surface without a pinch is left
  };
  Neighbours neighbours(int v, int w) const;
  /// Puts w in the place of v in all triangles.
  void replace(int v, int w);
  static std::uint64_t key(int a, int b) {
    if (a > b) std::swap(a, b);
    return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
  }
  void add(const SurfaceTriangle& triangle);
  void remove(int t);
  /// As long as twice the triangle's area.
  Vec3 normal(const SurfaceTriangle& triangle) const;
  /// Altitude of a triangle over its longest edge, as part of that edge; 0 where it is flat.
  double slenderness(const std::array<int, 3>& v) const;
  bool faces_out(const std::array<int, 3>& v, int face, double slenderest) const;

  const MeshState& state_;
  std::vector<std::vector<int>> at_;
  std::unordered_map<std::uint64_t, int> creases_;
};

}  // namespace fgmesh
