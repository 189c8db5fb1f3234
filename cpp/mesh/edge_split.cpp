// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_split.hpp"

#include <algorithm>

#include "mesh/cavity.hpp"

namespace fgmesh {
namespace {

/// Squared lengths that differ by less are alike.
constexpr double kClearlyLonger = 1.0 + 1e-6;

/// All tetrahedra at an edge. Where solids touch along it they are more than those of its ring.
std::vector<int> tets_at(const TetComplex& complex, int a, int b, const EdgeRing& ring) {
  if (!complex.is_pinched(a) || !complex.is_pinched(b)) return ring.tet;
  std::vector<int> around;
  complex.star(a, around);
  around.erase(std::remove_if(around.begin(), around.end(), [&](int t) { return !complex.tet(t).has(b); }),
               around.end());
  return around;
}

}  // namespace

int split_edge(MeshState& state, int a, int b, int t) {
  TetComplex& complex = state.complex;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  const std::optional<Vertex> placed = state.on_edge(a, b, state.label_at(a, b, ring));
  if (!placed) return -1;
  const std::vector<int> around = tets_at(complex, a, b, ring);
  Cavity cavity(state, a, b, around);
  if (!cavity.open(*placed)) return -1;

  const int middle = state.add(*placed);
  complex.replace(cavity.tets(), cavity.filling(middle), cavity.facets(middle));
  if (around.size() > ring.tet.size()) complex.pinch(middle);
  if (const int edge = complex.crease(a, b)) {
    complex.clear_crease(a, b);
    complex.set_crease(a, middle, edge);
    complex.set_crease(middle, b, edge);
  }
  return middle;
}

bool insert_beside_edge(MeshState& state, int a, int b, const Vec3& place, const TetScore& score,
                        double gain) {
  TetComplex& complex = state.complex;
  const int t = complex.find_edge(a, b);
  if (t < 0) return false;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  if (state.label_at(a, b, ring)) return false;
  Vertex placed;
  placed.position = place;
  placed.carrier = {3, complex.tet(t).solid};
  placed.size = 0.5 * (state.vertices[a].size + state.vertices[b].size);
  placed.stretch = 0.5 * (state.vertices[a].stretch + state.vertices[b].stretch);
  if (!state.evaluate(placed)) return false;
  Cavity cavity(state, a, b, ring.tet);
  if (!cavity.open(placed)) return false;
  double least = 1.0;
  for (int old : cavity.tets()) least = std::min(least, score(old));
  least += gain;

  const int middle = static_cast<int>(state.vertices.size());
  const std::vector<NewTet> filling = cavity.filling(middle);
  const auto vertex = [&](int v) -> const Vertex& { return v == middle ? placed : state.vertices[v]; };
  for (const auto& [v, solid] : filling)
    if (score.of(vertex(v[0]), vertex(v[1]), vertex(v[2]), vertex(v[3])) < least) return false;
  state.add(placed);
  complex.replace(cavity.tets(), filling, {});
  return true;
}

int split_boundary_edge(MeshState& state, int a, int b, int t) {
  const auto length = [&](int p, int q) { return (state.position(p) - state.position(q)).squaredNorm(); };
  EdgeRing ring;
  // Lengths rise along the path, so that it ends.
  for (double longest = length(a, b);;) {
    state.complex.ring(a, b, t, ring);
    const int from_a = a, from_b = b;
    for (int around : ring.tet) {
      const Tet& tet = state.complex.tet(around);
      for (int i = 0; i < 4; ++i) {
        if (!tet.label[i] || tet.vertex[i] == from_a || tet.vertex[i] == from_b) continue;
        for (int k = 0; k < 3; ++k) {
          const int p = tet.vertex[kFaceVertices[i][k]], q = tet.vertex[kFaceVertices[i][(k + 1) % 3]];
          if (length(p, q) <= longest * kClearlyLonger) continue;
          longest = length(p, q);
          a = p;
          b = q;
          t = around;
        }
      }
    }
    if (a == from_a && b == from_b) return split_edge(state, a, b, t);
  }
}

int split_long_edges(MeshState& state, const Excess& excess, RunControl& control) {
  TetComplex& complex = state.complex;
  const int old_vertices = complex.vertex_slots();
  int count = 0;
  for (int t = 0; t < complex.slots(); ++t) {
    if (t % 1024 == 0) control.check();
    if (!complex.tet(t).alive()) continue;
    const std::array<int, 4> v = complex.tet(t).vertex;
    if (*std::max_element(v.begin(), v.end()) >= old_vertices) continue;
    double largest = 1.0;
    std::array<int, 2> edge = {-1, -1};
    for (const auto& [i, j] : kEdgeVertices) {
      const double length = (state.position(v[i]) - state.position(v[j])).norm();
      if (length < 2.0 * state.min_size) continue;
      const double found = excess(v[i], v[j], length);
      if (found <= largest) continue;
      largest = found;
      edge = {v[i], v[j]};
    }
    if (edge[0] >= 0 && split_edge(state, edge[0], edge[1], t) >= 0) ++count;
  }
  return count;
}

int split_long_edges(MeshState& state, double longest, RunControl& control) {
  if (std::isinf(longest)) return 0;
  return split_long_edges(
      state, [=](int, int, double length) { return length / longest; }, control);
}

int resolve_boundary(MeshState& state, RunControl& control) {
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
        if ((a.position - b.position).norm() < 2.0 * state.min_size) continue;
        if (chord_error(state, a, b, first ? first : second) > allowed_chord_error(state, a, b) &&
            split_boundary_edge(state, tet.vertex[i], tet.vertex[j], t) >= 0)
          ++count;
      }
    }
  }
  return count;
}

}  // namespace fgmesh
