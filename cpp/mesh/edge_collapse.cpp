// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_collapse.hpp"

namespace fgmesh {

bool collapse_edge(MeshState& state, int vertex, int target, const TetScore& score, double least,
                   double variation) {
  if (state.vertices[vertex].carrier.dimension != 3) return false;
  TetComplex& complex = state.complex;
  std::vector<int> star;
  complex.star(vertex, star);
  std::vector<NewTet> filling;
  for (int t : star) {
    const Tet& tet = complex.tet(t);
    if (tet.has(target)) continue;
    NewTet made{tet.vertex, tet.solid};
    made.vertex[tet.index_of(vertex)] = target;
    if (state.variation(made.vertex) > variation || score(made.vertex) < least) return false;
    filling.push_back(made);
  }
  complex.replace(star, filling, {});
  return true;
}

}  // namespace fgmesh
