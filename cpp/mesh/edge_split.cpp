// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_split.hpp"

namespace fgmesh {
namespace {

/// Squared lengths that differ by less are alike.
constexpr double kClearlyLonger = 1.0 + 1e-6;

/// True where face i of the tetrahedron has the edge (a, b).
bool at_edge(const Tet& tet, int i, int a, int b) {
  return tet.vertex[i] != a && tet.vertex[i] != b && tet.has(a) && tet.has(b);
}

/// Grows `cavity`, at first the ring of (a, b), by the tetrahedra behind those of its faces that a vertex at
/// `place` does not see from inside. False where such a face is labelled. The cavity is marked by `stamp`.
bool open_cavity(const MeshState& state, int a, int b, const Vec3& place, std::vector<int>& cavity,
                 int stamp) {
  constexpr std::size_t kLargest = 96;
  const TetComplex& complex = state.complex;
  for (int t : cavity) complex.mark(t, stamp);
  for (std::size_t next = 0; next < cavity.size(); ++next) {
    const Tet& tet = complex.tet(cavity[next]);
    for (int i = 0; i < 4; ++i) {
      const int behind = tet.neighbour[i];
      if (at_edge(tet, i, a, b) || (behind >= 0 && !tet.label[i] && complex.marked(behind, stamp))) continue;
      const auto at = [&](int k) -> const Vec3& { return k == i ? place : state.position(tet.vertex[k]); };
      if (is_positive(at(0), at(1), at(2), at(3))) continue;
      if (behind < 0 || tet.label[i] || cavity.size() == kLargest) return false;
      complex.mark(behind, stamp);
      cavity.push_back(behind);
    }
  }
  // A wall between two solids must not end inside.
  return std::none_of(cavity.begin(), cavity.end(), [&](int t) {
    const Tet& tet = complex.tet(t);
    for (int i = 0; i < 4; ++i)
      if (tet.label[i] && tet.neighbour[i] >= 0 && complex.marked(tet.neighbour[i], stamp) &&
          !at_edge(tet, i, a, b))
        return true;
    return false;
  });
}

/// The faces of the marked cavity joined with a new vertex on (a, b).
std::vector<NewTet> fill_cavity(const TetComplex& complex, int a, int b, int vertex,
                                const std::vector<int>& cavity, int stamp) {
  std::vector<NewTet> filling;
  for (int t : cavity) {
    const Tet& tet = complex.tet(t);
    for (int i = 0; i < 4; ++i) {
      const int behind = tet.neighbour[i];
      if (at_edge(tet, i, a, b) || (behind >= 0 && complex.marked(behind, stamp))) continue;
      filling.push_back({tet.vertex, tet.solid});
      filling.back().vertex[i] = vertex;
    }
  }
  return filling;
}

}  // namespace

int split_edge(MeshState& state, int a, int b, int t) {
  TetComplex& complex = state.complex;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  const std::optional<Vertex> placed = state.on_edge(a, b, state.label_at(a, b, ring));
  if (!placed) return -1;
  std::vector<int> cavity = ring.tet;
  const int stamp = complex.fresh_stamp();
  if (!open_cavity(state, a, b, placed->position, cavity, stamp)) return -1;

  const int middle = state.add(*placed);
  const std::vector<NewTet> filling = fill_cavity(complex, a, b, middle, cavity, stamp);
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
  complex.replace(cavity, filling, facets);
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
  placed.size = 0.5 * (state.vertices[a].size + state.vertices[b].size);
  if (!state.evaluate(placed)) return false;
  std::vector<int> cavity = ring.tet;
  const int stamp = complex.fresh_stamp();
  if (!open_cavity(state, a, b, place, cavity, stamp)) return false;
  double least = 1.0;
  for (int old : cavity) least = std::min(least, score(old));
  least += gain;

  const int middle = static_cast<int>(state.vertices.size());
  const std::vector<NewTet> filling = fill_cavity(complex, a, b, middle, cavity, stamp);
  const auto vertex = [&](int v) -> const Vertex& { return v == middle ? placed : state.vertices[v]; };
  for (const auto& [v, solid] : filling)
    if (score.of(vertex(v[0]), vertex(v[1]), vertex(v[2]), vertex(v[3])) < least) return false;
  state.add(placed);
  complex.replace(cavity, filling, {});
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
            split_boundary_edge(state, tet.vertex[i], tet.vertex[j], t) >= 0)
          ++count;
      }
    }
  }
  return count;
}

}  // namespace fgmesh
