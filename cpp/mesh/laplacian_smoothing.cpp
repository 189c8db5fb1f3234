// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/laplacian_smoothing.hpp"

namespace fgmesh {
namespace {

/// The neighbours that hold vertex v in place: all of them inside a solid, those joined by a boundary edge on
/// a face, those along the crease on an edge.
std::vector<int> holding_neighbours(const MeshState& state, int v, const std::vector<int>& star) {
  const int dimension = state.vertices[v].carrier.dimension;
  std::vector<int> found;
  for (int t : star) {
    const Tet& tet = state.complex.tet(t);
    for (int i = 0; i < 4; ++i) {
      const int w = tet.vertex[i];
      if (w == v) continue;
      bool holds = dimension == 3;
      if (dimension == 1) holds = state.complex.crease(v, w) != 0;
      for (int face = 0; dimension == 2 && face < 4; ++face)
        holds = holds || (tet.label[face] && face != i && tet.vertex[face] != v);
      if (holds) found.push_back(w);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// True where no tetrahedron of the star comes above the threshold, or farther above it, with v moved.
bool keeps_threshold(const MeshState& state, int v, const Vertex& moved, const std::vector<int>& star) {
  return std::all_of(star.begin(), star.end(), [&](int t) {
    const std::array<int, 4>& index = state.complex.tet(t).vertex;
    const auto at = [&](int i) -> const Vertex& { return index[i] == v ? moved : state.vertices[index[i]]; };
    const double changed = variation(at(0), at(1), at(2), at(3));
    return changed <= state.threshold() || changed <= state.variation(t);
  });
}

}  // namespace

void laplacian_sweep(MeshState& state, const TetScore& shape, double floor, RunControl& control) {
  std::vector<int> star;
  for (int v = 0; v < state.complex.vertex_slots(); ++v) {
    if (v % 512 == 0) control.check();
    const Vertex& vertex = state.vertices[v];
    if (vertex.frozen || vertex.is_fixed() || state.complex.tet_at(v) < 0) continue;
    state.complex.star(v, star);
    const std::vector<int> neighbours = holding_neighbours(state, v, star);
    if (neighbours.empty()) continue;
    Vec3 mean = Vec3::Zero();
    for (int w : neighbours) mean += state.position(w) / static_cast<double>(neighbours.size());

    const std::optional<Vertex> moved = state.moved(vertex, mean);
    if (!moved || !may_move(state, v, *moved, star)) continue;
    double before = 1.0, after = 1.0;
    for (int t : star) before = std::min(before, shape(t));
    const double least = std::min(before, floor);
    for (int t : star) {
      after = std::min(after, shape.with(t, v, *moved));
      if (after < least) break;
    }
    if (after >= least && keeps_threshold(state, v, *moved, star)) state.vertices[v] = *moved;
  }
}

}  // namespace fgmesh
