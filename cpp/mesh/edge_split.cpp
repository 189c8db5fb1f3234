// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_split.hpp"

namespace fgmesh {
namespace {

/// A new vertex stands for itself by this until it has a number.
constexpr int kApex = -1;

/// Squared lengths that differ by less are alike.
constexpr double kClearlyLonger = 1.0 + 1e-6;

/// The hole that a new vertex on the edge (a, b) is put into: the tetrahedra around the edge, and whatever
/// hides the faces of the hole from the vertex. With it, the labelled facets at the edge and those folded
/// over.
class Cavity {
 public:
  /// False where the vertex cannot see the whole hole from `placed`.
  Cavity(const MeshState& state, int a, int b, const std::vector<int>& ring, const Vertex& placed)
      : tets(ring), state_(state), a_(a), b_(b), stamp_(state.complex.fresh_stamp()) {
    for (int t : tets) {
      state.complex.mark(t, stamp_);
      const Tet& tet = state.complex.tet(t);
      for (int i = 0; i < 4; ++i)
        if (tet.label[i] && tet.vertex[i] != a && tet.vertex[i] != b) open(t, i);
    }
    const std::size_t opened_at_edge = opened_.size();
    fits = grow(placed) && gather_tets() && gather_facets();
    if (opened_.size() == opened_at_edge) return;
    fits = fits && std::all_of(facets.begin(), facets.end(), [&](const LabelledFacet& facet) {
             const Vertex &p = state.vertices[facet.vertex[0]], &q = state.vertices[facet.vertex[1]];
             return faces_outward(p, q, placed);
           });
  }

  bool fits = false;
  std::vector<int> tets;
  std::vector<NewTet> filling;        ///< faces of the hole, joined with kApex
  std::vector<LabelledFacet> facets;  ///< borders of the opened facets, joined with kApex

 private:
  static constexpr std::size_t kLargest = 96;

  // A labelled facet, with its vertices in the order of kFaceVertices (outward from the tetrahedron it was
  // met in).
  void open(int t, int face) {
    const Tet& tet = state_.complex.tet(t);
    const int* k = kFaceVertices[face];
    if (!is_open(t, face))
      opened_.push_back({{tet.vertex[k[0]], tet.vertex[k[1]], tet.vertex[k[2]]}, tet.label[face]});
  }

  bool is_open(int t, int face) const {
    const Tet& tet = state_.complex.tet(t);
    return tet.label[face] && std::any_of(opened_.begin(), opened_.end(), [&](const LabelledFacet& facet) {
             return std::all_of(facet.vertex.begin(), facet.vertex.end(),
                                [&](int v) { return v != tet.vertex[face] && tet.has(v); });
           });
  }

  /// May be opened: shares an edge that is no crease with an opened facet of the same face.
  bool continues_opened(int t, int face) const {
    const Tet& tet = state_.complex.tet(t);
    return std::any_of(opened_.begin(), opened_.end(), [&](const LabelledFacet& facet) {
      if (facet.label != tet.label[face]) return false;
      std::array<int, 3> shared{};
      int count = 0;
      for (int v : facet.vertex)
        if (v != tet.vertex[face] && tet.has(v)) shared[count++] = v;
      return count == 2 && !state_.complex.crease(shared[0], shared[1]);
    });
  }

  bool take(int t) {
    if (!state_.complex.mark(t, stamp_)) return true;
    tets.push_back(t);
    return tets.size() <= kLargest;
  }

  bool is_inside(int t, int face) const {
    const Tet& tet = state_.complex.tet(t);
    const int behind = tet.neighbour[face];
    return !tet.label[face] && behind >= 0 && state_.complex.marked(behind, stamp_);
  }

  /// Takes in what hides a face of the hole from the vertex: the tetrahedron behind it, or the facet itself
  /// where the surface would fold over it.
  bool grow(const Vertex& placed) {
    for (std::size_t next = 0; next < tets.size(); ++next) {
      const int t = tets[next];
      for (int i = 0; i < 4; ++i) {
        if (is_inside(t, i) || is_open(t, i)) continue;
        const Tet& tet = state_.complex.tet(t);
        const auto at = [&](int k) -> const Vec3& {
          return k == i ? placed.position : state_.position(tet.vertex[k]);
        };
        if (is_positive(at(0), at(1), at(2), at(3))) continue;
        if (tet.label[i]) {
          if (!continues_opened(t, i)) return false;
          open(t, i);
        }
        if (tet.neighbour[i] >= 0 && !take(tet.neighbour[i])) return false;
      }
    }
    return true;
  }

  bool gather_tets() {
    for (int t : tets) {
      const Tet& tet = state_.complex.tet(t);
      for (int i = 0; i < 4; ++i) {
        if (is_inside(t, i) || is_open(t, i)) continue;
        // A wall between two solids must not end inside the hole.
        if (tet.neighbour[i] >= 0 && state_.complex.marked(tet.neighbour[i], stamp_)) return false;
        NewTet made{tet.vertex, tet.solid};
        made.vertex[i] = kApex;
        filling.push_back(made);
      }
    }
    return true;
  }

  /// False where a crease or a vertex of the boundary would be lost.
  bool gather_facets() {
    for (const LabelledFacet& facet : opened_) {
      for (int i = 0; i < 3; ++i) {
        const int p = facet.vertex[i], q = facet.vertex[(i + 1) % 3];
        const auto at_edge = [&](const LabelledFacet& other) {
          const auto has = [&](int v) {
            return std::find(other.vertex.begin(), other.vertex.end(), v) != other.vertex.end();
          };
          return has(p) && has(q);
        };
        const bool split = (p == a_ || p == b_) && (q == a_ || q == b_);
        if (split) continue;
        if (std::count_if(opened_.begin(), opened_.end(), at_edge) == 1) {
          facets.push_back({{p, q, kApex}, facet.label});
        } else if (state_.complex.crease(p, q)) {
          return false;
        }
      }
    }
    return std::all_of(opened_.begin(), opened_.end(), [&](const LabelledFacet& facet) {
      return std::all_of(facet.vertex.begin(), facet.vertex.end(), [&](int v) {
        const auto borders = std::count_if(facets.begin(), facets.end(), [&](const LabelledFacet& border) {
          return border.vertex[0] == v || border.vertex[1] == v;
        });
        return borders == 2 || (borders > 2 && (v == a_ || v == b_));
      });
    });
  }

  const MeshState& state_;
  int a_, b_;
  int stamp_;
  std::vector<LabelledFacet> opened_;
};

}  // namespace

int split_edge(MeshState& state, int a, int b, int t) {
  TetComplex& complex = state.complex;
  EdgeRing ring;
  complex.ring(a, b, t, ring);
  const std::optional<Vertex> placed = state.on_edge(a, b, state.label_at(a, b, ring));
  if (!placed) return -1;
  Cavity cavity(state, a, b, ring.tet, *placed);
  if (!cavity.fits) return -1;

  const int middle = state.add(*placed);
  for (NewTet& made : cavity.filling) std::replace(made.vertex.begin(), made.vertex.end(), kApex, middle);
  for (LabelledFacet& facet : cavity.facets) facet.vertex[2] = middle;
  complex.replace(cavity.tets, cavity.filling, cavity.facets);
  if (const int edge = complex.crease(a, b)) {
    complex.clear_crease(a, b);
    complex.set_crease(a, middle, edge);
    complex.set_crease(middle, b, edge);
  }
  return middle;
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
