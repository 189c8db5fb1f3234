// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_split.hpp"

namespace fgmesh {
namespace {

/// The tetrahedra that a new vertex replaces: the ring of an edge, and those behind ring faces that the
/// vertex does not see from inside.
struct Cavity {
  std::vector<int> tets;
  std::vector<NewTet> filling;  ///< the faces of the hole joined with the new vertex, which is kApex here
  static constexpr int kApex = -1;
};

/// Fills `cavity`, which holds the ring of (a, b), for a vertex at `place`. Faces that the vertex does not
/// see are opened by taking in the tetrahedron behind them; false where one of them is labelled.
bool open_cavity(const MeshState& state, int a, int b, const Vec3& place, Cavity& cavity) {
  constexpr std::size_t kLargest = 96;
  const TetComplex& complex = state.complex;
  const int stamp = complex.fresh_stamp();
  for (int t : cavity.tets) complex.mark(t, stamp);
  // Taking a tetrahedron in covers faces met before, so the faces are gathered once all are in.
  for (std::size_t next = 0; next < cavity.tets.size(); ++next) {
    const Tet& tet = complex.tet(cavity.tets[next]);
    for (int i = 0; i < 4; ++i) {
      const int behind = tet.neighbour[i];
      if (behind >= 0 && !tet.label[i] && complex.marked(behind, stamp)) continue;
      if (tet.vertex[i] != a && tet.vertex[i] != b && tet.has(a) && tet.has(b)) continue;  // at the edge
      const auto at = [&](int k) -> const Vec3& { return k == i ? place : state.position(tet.vertex[k]); };
      if (is_positive(at(0), at(1), at(2), at(3))) continue;
      if (behind < 0 || tet.label[i] || cavity.tets.size() == kLargest) return false;
      complex.mark(behind, stamp);
      cavity.tets.push_back(behind);
    }
  }
  for (int t : cavity.tets) {
    const Tet& tet = complex.tet(t);
    for (int i = 0; i < 4; ++i) {
      const int behind = tet.neighbour[i];
      if (behind >= 0 && complex.marked(behind, stamp)) {
        // Two solids of one cavity stay apart.
        const bool at_edge = tet.vertex[i] != a && tet.vertex[i] != b && tet.has(a) && tet.has(b);
        if (tet.label[i] && !at_edge) return false;
        continue;
      }
      if (tet.vertex[i] != a && tet.vertex[i] != b && tet.has(a) && tet.has(b)) continue;
      NewTet made{tet.vertex, tet.solid};
      made.vertex[i] = Cavity::kApex;
      cavity.filling.push_back(made);
    }
  }
  return true;
}

}  // namespace

int split_edge(MeshState& state, int a, int b, int t) {
  TetComplex& complex = state.complex;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  const std::optional<Vertex> placed = state.on_edge(a, b, state.label_at(a, b, ring));
  if (!placed) return -1;
  Cavity cavity;
  cavity.tets = ring.tet;
  if (!open_cavity(state, a, b, placed->position, cavity)) return -1;

  const int middle = state.add(*placed);
  for (NewTet& made : cavity.filling)
    std::replace(made.vertex.begin(), made.vertex.end(), Cavity::kApex, middle);
  std::vector<LabelledFacet> facets;
  for (int around : ring.tet) {
    const Tet& tet = complex.tet(around);
    for (int i = 0; i < 4; ++i) {
      if (!tet.label[i] || tet.vertex[i] == a || tet.vertex[i] == b) continue;
      int apex = -1;  // of the labelled facet, beside a and b
      for (int j = 0; j < 4; ++j)
        if (j != i && tet.vertex[j] != a && tet.vertex[j] != b) apex = tet.vertex[j];
      facets.push_back({{a, middle, apex}, tet.label[i]});
      facets.push_back({{middle, b, apex}, tet.label[i]});
    }
  }
  complex.replace(cavity.tets, cavity.filling, facets);
  if (const int edge = complex.crease(a, b)) {
    complex.clear_crease(a, b);
    complex.set_crease(a, middle, edge);
    complex.set_crease(middle, b, edge);
  }
  return middle;
}

int resolve_boundary(MeshState& state, double min_size, RunControl& control) {
  TetComplex& complex = state.complex;
  int count = 0;
  // Tetrahedra made on the way get slots further on or are met in the next pass.
  for (int before = -1; before != count;) {
    before = count;
    for (int t = 0; t < complex.slots(); ++t) {
      if (t % 1024 == 0) control.check();
      for (int e = 0; e < 6 && complex.tet(t).alive(); ++e) {
        const Tet& tet = complex.tet(t);
        const int i = kEdgeVertices[e][0], j = kEdgeVertices[e][1];
        // The faces at the edge are those opposite the other two vertices.
        const int first = tet.label[kEdgeVertices[5 - e][0]], second = tet.label[kEdgeVertices[5 - e][1]];
        if (!first && !second) continue;
        const Vertex &a = state.vertices[tet.vertex[i]], &b = state.vertices[tet.vertex[j]];
        if ((a.position - b.position).norm() < 2.0 * min_size) continue;
        if (chord_error(state, a, b, first ? first : second) > allowed_chord_error(state, a, b) &&
            split_edge(state, tet.vertex[i], tet.vertex[j], t) >= 0)
          ++count;
      }
    }
  }
  return count;
}

}  // namespace fgmesh
