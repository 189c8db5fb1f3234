// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/edge_collapse.hpp"

namespace fgmesh {
namespace {

using Triangle = std::array<int, 3>;

bool contains(const std::vector<int>& list, int v) {
  return std::find(list.begin(), list.end(), v) != list.end();
}

void insert(std::vector<int>& list, int v) {
  if (!contains(list, v)) list.push_back(v);
}

/// What is around a vertex.
struct Surroundings {
  Surroundings(const TetComplex& complex, int v) {
    complex.star(v, star);
    for (int t : star) {
      const Tet& tet = complex.tet(t);
      for (int i = 0; i < 4; ++i) {
        if (tet.vertex[i] == v) continue;
        neighbours.push_back(tet.vertex[i]);
        if (!tet.label[i]) continue;
        const int* k = kFaceVertices[i];
        facets.push_back({{tet.vertex[k[0]], tet.vertex[k[1]], tet.vertex[k[2]]}, tet.label[i]});
        for (int w : facets.back().vertex)
          if (w != v) on_boundary.push_back(w);
      }
    }
    for (std::vector<int>* list : {&neighbours, &on_boundary}) {
      std::sort(list->begin(), list->end());
      list->erase(std::unique(list->begin(), list->end()), list->end());
    }
  }
  bool is_neighbour(int w) const { return std::binary_search(neighbours.begin(), neighbours.end(), w); }
  bool is_on_boundary(int w) const { return std::binary_search(on_boundary.begin(), on_boundary.end(), w); }

  /// Whether (v, a, b) is a face of the mesh.
  bool has_face(const TetComplex& complex, int a, int b) const {
    return std::any_of(star.begin(), star.end(),
                       [&](int t) { return complex.tet(t).has(a) && complex.tet(t).has(b); });
  }

  std::vector<int> star;              // the tetrahedra at it
  std::vector<int> neighbours;        // the other ends of its edges, ascending
  std::vector<int> on_boundary;       // of those on the boundary or an interface
  std::vector<LabelledFacet> facets;  // the facets at it; those of an interface twice, seen from either solid
};

bool has(const Triangle& facet, int v) { return facet[0] == v || facet[1] == v || facet[2] == v; }

/// One vertex drawn onto another.
class Collapse {
 public:
  Collapse(const MeshState& state, int vertex, int target)
      : state_(state), vertex_(vertex), target_(target), around_(state.complex, vertex) {}

  /// Whether the edge is there and the vertex may leave its carrier's mesh.
  bool is_allowed() const {
    const TetComplex& complex = state_.complex;
    const Vertex& vertex = state_.vertices[vertex_];
    if (vertex.frozen || vertex.is_fixed() || !around_.is_neighbour(target_)) return false;
    if (complex.is_pinched(vertex_) || complex.is_pinched(target_)) return false;
    if (vertex.carrier.dimension == 2) return around_.is_on_boundary(target_);
    return vertex.carrier.dimension == 3 || complex.crease(vertex_, target_) != 0;
  }

  /// What the two vertices have in common is around their edge, in the mesh and on its boundary.
  bool keeps_complex() const {
    const TetComplex& complex = state_.complex;
    const Surroundings at_target(complex, target_);
    std::vector<int> link, on_facets;
    for (int t : around_.star) {
      const Tet& tet = complex.tet(t);
      const int i = tet.index_of(target_);
      if (i < 0) continue;
      // The faces opposite the two are laid upon each other.
      if (tet.label[i] && tet.label[tet.index_of(vertex_)]) return false;
      for (int k = 0; k < 4; ++k) {
        const int v = tet.vertex[k];
        if (v == vertex_ || v == target_) continue;
        insert(link, v);
        if (tet.label[k])
          for (int w : tet.vertex)
            if (w != v && w != vertex_ && w != target_) insert(on_facets, w);
      }
    }
    for (int v : around_.neighbours)
      if (v != target_ && at_target.is_neighbour(v) && !contains(link, v)) return false;
    for (int v : around_.on_boundary)
      if (v != target_ && at_target.is_on_boundary(v) && !contains(on_facets, v)) return false;
    for (int a : link)
      for (int b : link)
        if (a < b && around_.has_face(complex, a, b) && at_target.has_face(complex, a, b) &&
            !std::any_of(around_.star.begin(), around_.star.end(), [&](int t) {
              const Tet& tet = complex.tet(t);
              return tet.has(target_) && tet.has(a) && tet.has(b);
            }))
          return false;
    const int beyond = other_end();
    return beyond < 0 || !at_target.is_neighbour(beyond);
  }

  /// Makes the new tetrahedra; false where one of them does not score above `least`, or is too small.
  bool make_tets(const TetScore& score, double least) {
    for (int t : around_.star) {
      const Tet& tet = state_.complex.tet(t);
      if (tet.has(target_)) continue;
      NewTet made{tet.vertex, tet.solid};
      made.vertex[tet.index_of(vertex_)] = target_;
      if (!(score(made.vertex) > least)) return false;
      tets_.push_back(made);
    }
    return state_.may_be_made(tets_, around_.star);
  }

  bool keeps_surface() {
    const double crease_limit = std::max(state_.chord_limit, crease_error_around());
    const int beyond = other_end();
    if (beyond >= 0 && crease_error(state_, state_.vertices[target_], state_.vertices[beyond],
                                    state_.complex.crease(vertex_, target_)) > crease_limit)
      return false;
    for (const LabelledFacet& facet : around_.facets) {
      if (has(facet.vertex, target_)) continue;
      LabelledFacet made = facet;
      for (int& v : made.vertex)
        if (v == vertex_) v = target_;
      if (!is_close(made, facet)) return false;
      facets_.push_back(made);
    }
    return true;
  }

  void carry_out(MeshState& state, TetComplex::Site& site) const {
    TetComplex& complex = state.complex;
    const int beyond = other_end();
    if (beyond >= 0) {
      complex.set_crease(target_, beyond, complex.crease(vertex_, target_));
      complex.clear_crease(vertex_, target_);
      complex.clear_crease(vertex_, beyond);
    }
    complex.replace(around_.star, tets_, facets_, site);
  }

 private:
  /// The neighbour of a vertex of a crease on its other side; -1 for another vertex.
  int other_end() const {
    if (state_.vertices[vertex_].carrier.dimension != 1) return -1;
    for (int v : around_.neighbours)
      if (v != target_ && state_.complex.crease(vertex_, v)) return v;
    return -1;
  }

  double crease_error_around() const {
    double largest = 0.0;
    if (state_.vertices[vertex_].carrier.dimension != 1) return largest;
    for (int v : around_.neighbours)
      if (const int edge = state_.complex.crease(vertex_, v))
        largest = std::max(largest, crease_error(state_, state_.vertices[vertex_], state_.vertices[v], edge));
    return largest;
  }

  /// Whether a facet at the target is as close to the face as the one that it replaces, or close enough.
  bool is_close(const LabelledFacet& made, const LabelledFacet& old) const {
    const auto& x = state_.vertices;
    const Triangle& v = made.vertex;
    if (!faces_outward(state_, x[v[0]], x[v[1]], x[v[2]], made.label)) {
      // A facet between two solids is seen from either side.
      const Triangle& w = old.vertex;
      if (faces_outward(state_, x[w[0]], x[w[1]], x[w[2]], made.label)) return false;
      if (!faces_outward(state_, x[v[0]], x[v[2]], x[v[1]], made.label)) return false;
    }
    for (int w : v) {
      if (w == target_) continue;
      const double error = chord_error(state_, x[target_], x[w], made.label);
      if (error > allowed_chord_error(state_, x[target_], x[w]) &&
          error > chord_error(state_, x[vertex_], x[w], made.label))
        return false;
    }
    const Vec3 centre = (x[v[0]].position + x[v[1]].position + x[v[2]].position) / 3.0;
    return (state_.boundary().project_to_face(made.label, centre).position - centre).norm() <=
           state_.chord_limit;
  }

  const MeshState& state_;
  const int vertex_, target_;
  const Surroundings around_;
  std::vector<NewTet> tets_;
  std::vector<LabelledFacet> facets_;
};

}  // namespace

bool collapse_edge(MeshState& state, int vertex, int target, const TetScore& score, double least,
                   TetComplex::Site& site) {
  Collapse collapse(state, vertex, target);
  if (!collapse.is_allowed() || !collapse.make_tets(score, least) || !collapse.keeps_complex() ||
      !collapse.keeps_surface())
    return false;
  collapse.carry_out(state, site);
  return true;
}

}  // namespace fgmesh
