// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh_state.hpp"
#include "mesh/slot_set.hpp"

namespace fgmesh {

/// The tetrahedra that make room for a new vertex on, or near, an edge: those around the edge, and those
/// behind faces that hide them from the vertex. The hole that they leave is star-shaped about it.
class Cavity {
 public:
  /// `ring` holds the tetrahedra around the edge (a, b).
  Cavity(const MeshState& state, int a, int b, const std::vector<int>& ring);

  /// Grows until `vertex` sees all faces of the cavity from inside. Facets of the boundary that it does not
  /// see make room, too (a hollow wall, the plane beside a bent crease), where they are neighbours, on the
  /// same face, of those that do already. Inner vertices may go; vertices of faces only for a vertex of a
  /// crease. False where the boundary is in the way, or an edge would be too short.
  bool open(const Vertex& vertex);

  const std::vector<int>& tets() const { return tets_; }
  /// The new tetrahedra, all of which have the vertex number `v`.
  std::vector<NewTet> filling(int v) const;
  /// The new facets of the boundary, all of which have the vertex number `v`.
  std::vector<LabelledFacet> facets(int v) const;

 private:
  /// A facet of the boundary that makes room; counter-clockwise seen from outside a solid at it.
  struct Facet {
    std::array<int, 3> vertex;
    int label;
    bool between_solids;
  };
  /// Between such a facet and one that stays; counter-clockwise about the first.
  struct Border {
    int from, to, label;
    bool between_solids;
  };

  bool at_edge(const std::array<int, 3>& facet) const;
  bool is_removed(const std::array<int, 3>& facet) const;
  void add(int t);
  void remove_facet(int t, int face);
  bool may_go(const std::array<int, 3>& facet, int label) const;
  bool grow(const Vec3& place);
  bool find_border();
  bool keeps_min_size(const Vec3& place) const;
  bool keeps_frozen() const;
  bool keeps_surface(const Vertex& vertex) const;

  const MeshState& state_;
  const int a_, b_;
  std::vector<int> tets_;
  SlotSet met_;  // the same
  std::vector<Facet> removed_;
  std::vector<Border> border_;
};

}  // namespace fgmesh
