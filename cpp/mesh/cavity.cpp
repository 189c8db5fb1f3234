// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cavity.hpp"

namespace fgmesh {
namespace {

constexpr std::size_t kMostTets = 96;

std::array<int, 3> facet_of(const Tet& tet, int face) {
  const int* k = kFaceVertices[face];
  return {tet.vertex[k[0]], tet.vertex[k[1]], tet.vertex[k[2]]};
}

bool has(const std::array<int, 3>& facet, int v) { return facet[0] == v || facet[1] == v || facet[2] == v; }

}  // namespace

Cavity::Cavity(const MeshState& state, int a, int b, const std::vector<int>& ring)
    : state_(state), a_(a), b_(b) {
  for (int t : ring) add(t);
  for (int t : ring)
    for (int i = 0; i < 4; ++i)
      if (state.complex.tet(t).label[i] && at_edge(facet_of(state.complex.tet(t), i))) remove_facet(t, i);
}

bool Cavity::at_edge(const std::array<int, 3>& facet) const { return has(facet, a_) && has(facet, b_); }

bool Cavity::is_removed(const std::array<int, 3>& facet) const {
  return std::any_of(removed_.begin(), removed_.end(), [&](const Facet& removed) {
    return has(removed.vertex, facet[0]) && has(removed.vertex, facet[1]) && has(removed.vertex, facet[2]);
  });
}

void Cavity::add(int t) {
  if (met_.insert(t)) tets_.push_back(t);
}

void Cavity::remove_facet(int t, int face) {
  const Tet& tet = state_.complex.tet(t);
  if (is_removed(facet_of(tet, face))) return;
  removed_.push_back({facet_of(tet, face), tet.label[face], tet.neighbour[face] >= 0});
  if (tet.neighbour[face] >= 0) add(tet.neighbour[face]);
}

/// A facet may make room where it continues one that does across no crease.
bool Cavity::may_go(const std::array<int, 3>& facet, int label) const {
  for (const Facet& removed : removed_) {
    if (removed.label != label) continue;
    for (int i = 0; i < 3; ++i) {
      const int p = facet[i], q = facet[(i + 1) % 3];
      if (has(removed.vertex, p) && has(removed.vertex, q) && !state_.complex.crease(p, q)) return true;
    }
  }
  return false;
}

bool Cavity::grow(const Vec3& place) {
  const TetComplex& complex = state_.complex;
  bool hidden = true;  // by a facet of the boundary that could not go yet
  for (bool changed = true; changed && hidden;) {
    changed = hidden = false;
    for (std::size_t next = 0; next < tets_.size(); ++next) {
      const int t = tets_[next];
      for (int i = 0; i < 4; ++i) {
        const Tet& tet = complex.tet(t);
        const std::array<int, 3> facet = facet_of(tet, i);
        const int behind = tet.neighbour[i];
        if (tet.label[i] ? is_removed(facet) : at_edge(facet) || met_.contains(behind)) continue;
        const auto at = [&](int k) -> const Vec3& { return k == i ? place : state_.position(tet.vertex[k]); };
        if (is_positive(at(0), at(1), at(2), at(3))) continue;
        if (tets_.size() >= kMostTets) return false;
        if (!tet.label[i]) {
          add(behind);
        } else if (may_go(facet, tet.label[i])) {
          remove_facet(t, i);
        } else {
          hidden = true;
          continue;
        }
        changed = true;
      }
    }
  }
  return !hidden;
}

/// False where facets of two faces would come to lie upon each other.
bool Cavity::find_border() {
  for (const Facet& facet : removed_) {
    for (int i = 0; i < 3; ++i) {
      const int p = facet.vertex[i], q = facet.vertex[(i + 1) % 3];
      if ((p == a_ && q == b_) || (p == b_ && q == a_)) continue;
      const Facet* other = nullptr;
      for (const Facet& candidate : removed_)
        if (&candidate != &facet && has(candidate.vertex, p) && has(candidate.vertex, q)) other = &candidate;
      if (other && (other->label != facet.label || state_.complex.crease(p, q))) return false;
      if (!other) border_.push_back({p, q, facet.label, facet.between_solids});
    }
  }
  return true;
}

/// No vertex of an edge is lost, one of a face only for one of an edge, and no facet folds over.
bool Cavity::keeps_surface(const Vertex& vertex) const {
  for (const Facet& facet : removed_) {
    for (int v : facet.vertex) {
      const bool stays = v == a_ || v == b_ ||
                         std::any_of(border_.begin(), border_.end(),
                                     [&](const Border& edge) { return edge.from == v || edge.to == v; });
      if (!stays && (state_.vertices[v].carrier.dimension < 2 || vertex.carrier.dimension != 1)) return false;
    }
  }
  return std::all_of(border_.begin(), border_.end(), [&](const Border& edge) {
    const Vertex &from = state_.vertices[edge.from], &to = state_.vertices[edge.to];
    // Facets between two solids were read from either side.
    return faces_outward(state_, from, to, vertex, edge.label) ||
           (edge.between_solids && faces_outward(state_, to, from, vertex, edge.label));
  });
}

bool Cavity::keeps_frozen() const {
  std::vector<int> kept;
  for (const NewTet& made : filling(-1)) kept.insert(kept.end(), made.vertex.begin(), made.vertex.end());
  return std::all_of(tets_.begin(), tets_.end(), [&](int t) {
    const std::array<int, 4>& around = state_.complex.tet(t).vertex;
    return std::all_of(around.begin(), around.end(), [&](int v) {
      return !state_.vertices[v].frozen || std::find(kept.begin(), kept.end(), v) != kept.end();
    });
  });
}

/// Whether no new edge is too short.
bool Cavity::keeps_min_size(const Vec3& place) const {
  if (state_.min_size == 0.0) return true;
  double shortest = std::numeric_limits<double>::infinity();
  for (const NewTet& made : filling(-1))
    for (int v : made.vertex)
      if (v >= 0) shortest = std::min(shortest, (state_.position(v) - place).squaredNorm());
  return state_.may_be_made(shortest, tets_);
}

bool Cavity::open(const Vertex& vertex) {
  const std::size_t at_edge = removed_.size();
  if (!grow(vertex.position) || !find_border()) return false;
  if (!keeps_min_size(vertex.position) || (state_.keeps_frozen && !keeps_frozen())) return false;
  return removed_.size() == at_edge || keeps_surface(vertex);
}

std::vector<NewTet> Cavity::filling(int v) const {
  const TetComplex& complex = state_.complex;
  std::vector<NewTet> filling;
  for (int t : tets_) {
    const Tet& tet = complex.tet(t);
    for (int i = 0; i < 4; ++i) {
      const std::array<int, 3> facet = facet_of(tet, i);
      if (tet.label[i] ? is_removed(facet) : at_edge(facet) || met_.contains(tet.neighbour[i])) continue;
      filling.push_back({tet.vertex, tet.solid});
      filling.back().vertex[i] = v;
    }
  }
  return filling;
}

std::vector<LabelledFacet> Cavity::facets(int v) const {
  std::vector<LabelledFacet> facets;
  for (const Border& edge : border_) facets.push_back({{edge.from, edge.to, v}, edge.label});
  return facets;
}

}  // namespace fgmesh
