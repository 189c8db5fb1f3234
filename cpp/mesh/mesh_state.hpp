// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "core/composition.hpp"
#include "core/composition_field.hpp"
#include "core/tet_mesh.hpp"
#include "mesh/solid_materials.hpp"
#include "mesh/tet_complex.hpp"
#include "quality/tet_measures.hpp"

namespace fgmesh {

/// The composition at a place, in one of the materials that meet there.
struct MaterialValue {
  int material = 0;
  Composition composition;       ///< fractions clamped to [0, 1]
  CompositionGradient gradient;  ///< 1/mm; finite
};

/// A vertex of the mesh in progress, with all that is worth remembering about its place.
struct alignas(64) Vertex {
  // What ODT smoothing asks of millions of tetrahedra comes first, in one line of the cache.
  Vec3 position = Vec3::Zero();
  Vec3 stretch = Vec3::Zero();  ///< along the gradient, as long as the anisotropy there is above 1
  double size = 0.0;            ///< mu, mm: see SizingField
  Carrier carrier;
  std::array<double, 2> parameter{};  ///< (u, v) on its face, or (t, -) on its edge
  Vec3 direction = Vec3::Zero();      ///< unit normal of its face, or tangent of its edge
  MaterialValue own;                  ///< on an interface that in the lowest solid
  std::vector<MaterialValue> others;  ///< on an interface: those in the other materials that meet there
  bool frozen = false;                ///< M-vertex: the geometry-oriented refinement leaves it in place

  bool junction =
      false;  ///< where edges of the shape meet that do not in the shape, since what parted them is bridged

  /// A vertex of the shape, or like one: moved it would take edges off their curves.
  bool is_fixed() const { return carrier.dimension == 0 || junction; }

  /// The value in a material, which the vertex must have.
  const MaterialValue& in(int material) const;
  bool has(int material) const;
};

/// variation() of a tetrahedron at an interface.
double variation_at_interface(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d);

/// Variation of the composition in a tetrahedron: in the material that its vertices have in common, and in
/// the worst of them where they have several (all four on one interface).
inline double variation(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  if (a.others.empty() && b.others.empty() && c.others.empty() && d.others.empty())
    return composition_variation(a.own.composition, b.own.composition, c.own.composition, d.own.composition);
  return variation_at_interface(a, b, c, d);
}

/// The mesh between the stages: connectivity, vertices, and the two things every stage asks, the true
/// boundary and the material. Vertices stay on their carrier whatever is done to them.
class MeshState {
 public:
  MeshState(const BoundaryGeometry& boundary, SolidMaterials materials, double threshold, double diagonal)
      : boundary_(boundary), materials_(std::move(materials)), threshold_(threshold), diagonal_(diagonal) {}
  /// One material for all solids.
  MeshState(const BoundaryGeometry& boundary, const CompositionField& field, double threshold,
            double diagonal)
      : MeshState(boundary, SolidMaterials(field), threshold, diagonal) {}

  TetComplex complex;
  std::vector<Vertex> vertices;

  /// No edge of the boundary may be farther than about this from the true boundary, mm; see
  /// allowed_chord_error().
  double chord_limit = 0.0;

  /// No edge is made shorter than this, mm, but in place of one that is no longer: the initial mesh, made
  /// with 0, has as short ones as the shape.
  double min_size = 0.0;

  /// Frozen vertices are not given up either, to make room for new ones.
  bool keeps_frozen = false;

  double threshold() const { return threshold_; }
  double diagonal() const { return diagonal_; }
  const BoundaryGeometry& boundary() const { return boundary_; }
  const SolidMaterials& materials() const { return materials_; }
  /// The material of a tetrahedron.
  int material(int t) const { return materials_.of_solid(complex.tet(t).solid); }

  const Vec3& position(int v) const { return vertices[v].position; }

  double variation(const std::array<int, 4>& v) const {
    return fgmesh::variation(vertices[v[0]], vertices[v[1]], vertices[v[2]], vertices[v[3]]);
  }
  double variation(int t) const { return variation(complex.tet(t).vertex); }

  /// The vertex moved to the point of its carrier nearest to `target`, with f evaluated there. Nothing where
  /// the border of its face is in the way, or f is not defined at a place outside the true solid; throws
  /// InvalidInput where the material leaves [0, 1], or is not a number, at a point of the true solid.
  std::optional<Vertex> moved(const Vertex& vertex, const Vec3& target) const;

  /// A new vertex on the edge (a, b) at a + s (b - a), brought onto the carrier that the edge lies on.
  /// `label` is the FaceN of the boundary facets at the edge, 0 inside a solid.
  std::optional<Vertex> on_edge(int a, int b, int label, double s = 0.5) const;

  /// f and its gradient at the vertex's position, in all materials that meet at its carrier; false as for
  /// moved().
  bool evaluate(Vertex& vertex) const;

  /// The same in one material at a place on the carrier.
  bool evaluate(const Vec3& place, const Carrier& carrier, MaterialValue& result) const;

  /// The vertex brought onto its carrier at the place nearest to `target`; f is not evaluated.
  Vertex carried(const Vertex& vertex, const Vec3& target, bool near = true) const;

  /// FaceN of the boundary facets around an edge's ring; 0 where none is labelled. With several (a crease),
  /// the first.
  int label_at(int a, int b, const EdgeRing& ring) const;

  /// Adds a vertex to the mesh (in no tetrahedron yet).
  int add(const Vertex& vertex);

  /// Puts vertices that are near each other, and their tetrahedra, near each other in memory, for the sake of
  /// its caches. All numbers change.
  void sort_by_place();

  /// Whether an edge of this length, squared, may come in place of what there is of the tetrahedra.
  bool may_be_made(double squared_length, const std::vector<int>& in_place_of) const;
  /// The same of all edges of new tetrahedra.
  bool may_be_made(const std::vector<NewTet>& made, const std::vector<int>& in_place_of) const;

  /// The finished arrays; vertices in the order of their slots, unused ones left out.
  TetMesh to_tet_mesh(std::vector<int>* vertex_order = nullptr) const;

 private:
  double shortest_edge_squared(const std::array<int, 4>& v) const;
  /// SolidN around the inner mesh edge (a, b).
  int solid_around(int a, int b) const;

  const BoundaryGeometry& boundary_;
  SolidMaterials materials_;
  double threshold_;
  double diagonal_;
};

/// About how far the middle of an edge (a, b) of facets on face `label` is from the true boundary, mm: for an
/// arc of a circle the angle between chord and tangent gives the sagitta; where neither end knows the normal
/// of the face, by projection.
double chord_error(const MeshState& state, const Vertex& a, const Vertex& b, int label);

/// Distance of the middle of an edge (a, b) along the crease `edge` to the true edge, mm.
double crease_error(const MeshState& state, const Vertex& a, const Vertex& b, int edge);

/// The chord error that moves and swaps may leave at the boundary edge (a, b), mm: MeshState::chord_limit,
/// and less where the mesh is to be fine. Inner vertices would stray into the gap between a coarse facet and
/// its true face otherwise.
double allowed_chord_error(const MeshState& state, const Vertex& a, const Vertex& b);

/// Lowers Vertex::size until it grows by at most `growth` mm a mm along the mesh's edges.
void limit_growth(MeshState& state, double growth);

/// True where a vertex brought onto its face from `target` was stopped by the border of the face: its nearest
/// point is not the one that `target` lies above. Such a vertex would sit on an edge of the shape without
/// belonging to it.
bool is_at_border(const Vertex& vertex, const Vec3& target);

/// True where every tetrahedron of the star stays positively oriented with v at `place`.
bool stays_positive(const MeshState& state, int v, const Vec3& place, const std::vector<int>& star);

/// True where the facet (a, b, c) of face `label`, counter-clockwise seen from outside, faces the way of the
/// true surface at those vertices that know its normal; where none does, at its centre.
bool faces_outward(const MeshState& state, const Vertex& a, const Vertex& b, const Vertex& c, int label);

/// True where a vertex may go to `moved` without making an edge too short, taking an edge of the boundary
/// beyond allowed_chord_error(), or farther than it is, or folding a facet over. `star` holds the tetrahedra
/// at v.
bool may_move(const MeshState& state, int v, const Vertex& moved, const std::vector<int>& star);

/// True where the tetrahedron is positively oriented with some margin above rounding.
inline bool is_positive(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double margin = 1e-6) {
  const double squared = squared_edges(a, b, c, d);
  return orientation(a, b, c, d) > margin * squared * std::sqrt(squared);
}

}  // namespace fgmesh
