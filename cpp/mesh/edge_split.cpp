// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_split.hpp"

namespace fgmesh {
namespace {

std::array<int, 4> with_vertex(std::array<int, 4> tet, int old_vertex, int new_vertex) {
  for (int& v : tet)
    if (v == old_vertex) v = new_vertex;
  return tet;
}

/// The tetrahedra of the ring that a vertex at `place` instead of a or b would turn over.
std::vector<int> overturned(const MeshState& state, const EdgeRing& ring, int a, int b, const Vec3& place) {
  std::vector<int> found;
  for (int around : ring.tet) {
    const std::array<int, 4>& v = state.complex.tet(around).vertex;
    bool positive = true;
    for (int end : {a, b}) {
      const auto at = [&](int i) -> const Vec3& { return v[i] == end ? place : state.position(v[i]); };
      positive = positive && is_positive(at(0), at(1), at(2), at(3));
    }
    if (!positive) found.push_back(around);
  }
  return found;
}

/// Moves inner vertices of the ring that stand between a boundary edge and its true face out of the way.
bool clear_way(MeshState& state, const EdgeRing& ring, int a, int b, const Vec3& place) {
  const Vec3 way = place - 0.5 * (state.position(a) + state.position(b));
  std::vector<int> star;
  bool any = false;
  for (int around : overturned(state, ring, a, b, place)) {
    const std::array<int, 4> vertices = state.complex.tet(around).vertex;
    for (int w : vertices) {
      Vertex& vertex = state.vertices[w];
      if (w == a || w == b || vertex.carrier.dimension != 3 || vertex.frozen) continue;
      state.complex.star(w, star);
      for (double part : {2.0, 1.0, 0.5}) {
        const std::optional<Vertex> moved = state.moved(vertex, vertex.position + part * way);
        if (!moved || !stays_positive(state, w, moved->position, star)) continue;
        vertex = *moved;
        any = true;
        break;
      }
    }
  }
  return any;
}

}  // namespace

int split_edge(MeshState& state, int a, int b, int t) {
  TetComplex& complex = state.complex;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  const std::optional<Vertex> placed = state.on_edge(a, b, state.label_at(a, b, ring));
  if (!placed) return -1;
  constexpr int kAttempts = 4;
  for (int attempt = 0; !overturned(state, ring, a, b, placed->position).empty(); ++attempt)
    if (attempt == kAttempts || !clear_way(state, ring, a, b, placed->position)) return -1;

  const int middle = state.add(*placed);
  std::vector<NewTet> filling;
  std::vector<LabelledFacet> facets;
  for (int around : ring.tet) {
    const Tet& tet = complex.tet(around);
    filling.push_back({with_vertex(tet.vertex, a, middle), tet.solid});
    filling.push_back({with_vertex(tet.vertex, b, middle), tet.solid});
    for (int i = 0; i < 4; ++i) {
      if (!tet.label[i] || tet.vertex[i] == a || tet.vertex[i] == b) continue;
      int apex = -1;  // of the labelled facet, beside a and b
      for (int j = 0; j < 4; ++j)
        if (j != i && tet.vertex[j] != a && tet.vertex[j] != b) apex = tet.vertex[j];
      facets.push_back({{a, middle, apex}, tet.label[i]});
      facets.push_back({{middle, b, apex}, tet.label[i]});
    }
  }
  complex.replace(ring.tet, filling, facets);
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
