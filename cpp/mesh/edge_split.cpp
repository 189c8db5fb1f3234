// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_split.hpp"

namespace fgmesh {
namespace {

std::array<int, 4> with_vertex(std::array<int, 4> tet, int old_vertex, int new_vertex) {
  for (int& v : tet)
    if (v == old_vertex) v = new_vertex;
  return tet;
}

}  // namespace

int split_edge(MeshState& state, int a, int b, int t) {
  TetComplex& complex = state.complex;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  const std::optional<Vertex> placed = state.on_edge(a, b, state.label_at(a, b, ring));
  if (!placed) return -1;

  for (int around : ring.tet) {
    std::array<const Vec3*, 4> corner;
    const Tet& tet = complex.tet(around);
    for (int end : {a, b}) {
      for (int i = 0; i < 4; ++i)
        corner[i] = tet.vertex[i] == end ? &placed->position : &state.position(tet.vertex[i]);
      if (!is_positive(*corner[0], *corner[1], *corner[2], *corner[3])) return -1;
    }
  }

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

}  // namespace fgmesh
