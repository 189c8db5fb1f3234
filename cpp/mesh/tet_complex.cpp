// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_complex.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "mesh/slot_set.hpp"
#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

std::array<int, 3> face_of(const std::array<int, 4>& tet, int face) {
  return {tet[kFaceVertices[face][0]], tet[kFaceVertices[face][1]], tet[kFaceVertices[face][2]]};
}

std::array<int, 3> sorted(std::array<int, 3> v) {
  if (v[0] > v[1]) std::swap(v[0], v[1]);
  if (v[1] > v[2]) std::swap(v[1], v[2]);
  if (v[0] > v[1]) std::swap(v[0], v[1]);
  return v;
}

/// Which face of the tetrahedron has these vertices. Not told by its neighbours: those across its other faces
/// may be another thread's business.
int face_on(const Tet& tet, const std::array<int, 3>& vertices) {
  int i = 0;
  while (std::find(vertices.begin(), vertices.end(), tet.vertex[i]) != vertices.end()) ++i;
  return i;
}

}  // namespace

void TetComplex::build(const std::vector<NewTet>& tets, const std::vector<LabelledFacet>& facets,
                       int vertex_count) {
  tets_.clear();
  own_ = Site();
  own_.may_grow_ = true;
  creases_.clear();
  tet_of_.assign(vertex_count, -1);
  tets_.reserve(tets.size());
  for (const NewTet& tet : tets) {
    const int t = static_cast<int>(tets_.size());
    tets_.emplace_back();
    tets_[t].vertex = tet.vertex;
    tets_[t].solid = tet.solid;
    for (int v : tet.vertex) tet_of_[v] = t;
  }
  alive_ = static_cast<int>(tets_.size());

  struct Side {
    std::array<int, 3> vertex;
    int tet, face;  // tet -1: a labelled facet, its label in `face`
  };
  std::vector<Side> sides;
  sides.reserve(4 * tets_.size() + facets.size());
  for (const LabelledFacet& facet : facets) sides.push_back({sorted(facet.vertex), -1, facet.label});
  for (int t = 0; t < slots(); ++t)
    for (int i = 0; i < 4; ++i) sides.push_back({sorted(face_of(tets_[t].vertex, i)), t, i});
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& a, const Side& b) { return a.vertex < b.vertex; });

  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    int label = 0;
    std::vector<const Side*> owners;
    for (; last < sides.size() && sides[last].vertex == sides[first].vertex; ++last) {
      if (sides[last].tet < 0)
        label = sides[last].face;
      else
        owners.push_back(&sides[last]);
    }
    first = last;
    if (owners.empty()) continue;
    if (owners.size() > 2) throw GeometryError("the initial mesh is no complex: a face of three tetrahedra");
    if (owners.size() == 1 && label == 0)
      throw GeometryError("the initial mesh has a boundary facet that belongs to no face of the shape");
    for (std::size_t i = 0; i < owners.size(); ++i) {
      Tet& tet = tets_[owners[i]->tet];
      tet.label[owners[i]->face] = label;
      tet.neighbour[owners[i]->face] = owners.size() == 2 ? owners[1 - i]->tet : -1;
    }
  }
  find_pinched();
}

void TetComplex::find_pinched() {
  pinched_.clear();
  std::vector<std::size_t> uses(vertex_slots(), 0);
  for (const Tet& tet : tets_)
    for (int v : tet.vertex) ++uses[v];
  std::vector<int> around;
  for (int v = 0; v < vertex_slots(); ++v) {
    star(v, around);
    if (around.size() < uses[v]) pinched_[v];
  }
  for (int t = 0; t < slots() && !pinched_.empty(); ++t)
    for (int v : tets_[t].vertex)
      if (is_pinched(v)) pinched_[v].push_back(t);
}

void TetComplex::pinch(int v) {
  std::vector<int>& all = pinched_[v];
  for (int t : created())
    if (tets_[t].has(v)) all.push_back(t);
}

void TetComplex::star(int v, std::vector<int>& star) const {
  star.clear();
  if (const auto pinched = pinched_.find(v); pinched != pinched_.end()) {
    star = pinched->second;
    return;
  }
  const int first = tet_of_[v];
  if (first < 0) return;
  SlotSet met;
  met.insert(first);
  star.push_back(first);
  for (std::size_t next = 0; next < star.size(); ++next) {
    const Tet& tet = tets_[star[next]];
    for (int i = 0; i < 4; ++i) {
      // Across the face opposite another thread may be at work.
      if (tet.vertex[i] == v) continue;
      const int other = tet.neighbour[i];
      if (other >= 0 && met.insert(other)) star.push_back(other);
    }
  }
}

template <class Accept>
bool TetComplex::walk_ring(int a, int b, int t, EdgeRing& ring, const Accept& accept) const {
  const int known = a ^ b;
  const auto start_at = [&](int from) {
    ring.tet.clear();
    ring.link.assign(1, from);
  };
  // Steps over the face that `from` does not touch; gives the next tetrahedron and the vertex ahead.
  const auto step = [&](int current, int from, int& ahead) {
    const Tet& tet = tets_[current];
    ahead = tet.vertex[0] ^ tet.vertex[1] ^ tet.vertex[2] ^ tet.vertex[3] ^ known ^ from;
    return tet.neighbour[tet.index_of(from)];
  };
  int first = 0;
  while (tets_[t].vertex[first] == a || tets_[t].vertex[first] == b) ++first;
  int current = t, from = tets_[t].vertex[first], ahead = -1;
  // Walk one way; where that ends at the boundary, start there and walk the whole ring the other way.
  start_at(from);
  ring.closed = true;
  while (true) {
    ring.tet.push_back(current);
    const int next = step(current, from, ahead);
    if (next == t) return true;
    if (next < 0) break;
    if (!accept(next)) return false;
    ring.link.push_back(ahead);
    from = ahead;
    current = next;
  }
  ring.closed = false;
  from = ahead;
  start_at(from);
  while (true) {
    ring.tet.push_back(current);
    const int next = step(current, from, ahead);
    ring.link.push_back(ahead);
    if (next < 0) return true;
    if (!accept(next)) return false;
    from = ahead;
    current = next;
  }
}

void TetComplex::ring(int a, int b, int t, EdgeRing& ring) const {
  walk_ring(a, b, t, ring, [](int) { return true; });
}

bool TetComplex::small_ring(int a, int b, int t, std::size_t most, EdgeRing& ring) const {
  return walk_ring(a, b, t, ring, [&](int) { return ring.tet.size() < most; });
}

bool TetComplex::ring_of_first(int a, int b, int t, EdgeRing& ring) const {
  return walk_ring(a, b, t, ring, [t](int other) { return other >= t; });
}

int TetComplex::find_edge(int a, int b) const {
  std::vector<int> around;
  star(a, around);
  for (int t : around)
    if (tets_[t].has(b)) return t;
  return -1;
}

int TetComplex::new_slot(Site& site) {
  if (!site.free_.empty()) {
    const int t = site.free_.back();
    site.free_.pop_back();
    return t;
  }
  tets_.emplace_back();
  return static_cast<int>(tets_.size()) - 1;
}

TetComplex::Site::HoleFace& TetComplex::Site::hole_face(std::array<int, 3> vertices) {
  vertices = sorted(vertices);
  const std::size_t mask = hole_table_.size() - 1;
  std::size_t place = (static_cast<std::size_t>(vertices[0]) * 73856093u) ^
                      (static_cast<std::size_t>(vertices[1]) * 19349663u) ^
                      (static_cast<std::size_t>(vertices[2]) * 83492791u);
  for (place &= mask; hole_table_[place] >= 0; place = (place + 1) & mask)
    if (hole_[hole_table_[place]].vertex == vertices) return hole_[hole_table_[place]];
  hole_table_[place] = static_cast<int>(hole_.size());
  hole_.push_back({vertices});
  return hole_.back();
}

bool TetComplex::replace(const std::vector<int>& cavity, const std::vector<NewTet>& filling,
                         const std::vector<LabelledFacet>& facets, Site& site) {
  if (!site.may_grow_ && site.free_.size() + cavity.size() < filling.size()) return false;
  std::size_t size = 64;
  while (size < 8 * (cavity.size() + filling.size())) size *= 2;
  site.hole_table_.assign(size, -1);
  site.hole_.clear();

  for (int t : cavity) tets_[t].solid = 0;
  for (int t : cavity) {
    for (int i = 0; i < 4; ++i) {
      const int outer = tets_[t].neighbour[i];
      if (outer >= 0 && !tets_[outer].alive()) continue;
      Site::HoleFace& face = site.hole_face(face_of(tets_[t].vertex, i));
      face.label = tets_[t].label[i];
      if (outer < 0) continue;
      face.tet = outer;
      face.face = face_on(tets_[outer], face.vertex);
      tets_[outer].neighbour[face.face] = -1;
    }
  }
  for (const LabelledFacet& facet : facets) site.hole_face(facet.vertex).label = facet.label;
  for (const Site::HoleFace& face : site.hole_)
    if (face.tet >= 0) tets_[face.tet].label[face.face] = face.label;

  for (int t : cavity) {
    for (int v : tets_[t].vertex) {
      tet_of_[v] = -1;
      if (const auto pinched = pinched_.find(v); pinched != pinched_.end())
        pinched->second.erase(std::find(pinched->second.begin(), pinched->second.end(), t));
    }
    site.free_.push_back(t);
  }
  for (const Site::HoleFace& face : site.hole_)
    if (face.tet >= 0)
      for (int v : face.vertex) tet_of_[v] = face.tet;
  site.created_.clear();
  for (const NewTet& made : filling) {
    const int t = new_slot(site);
    site.created_.push_back(t);
    tets_[t] = Tet{made.vertex, {-1, -1, -1, -1}, {}, made.solid};
    for (int v : made.vertex) {
      tet_of_[v] = t;
      if (const auto pinched = pinched_.find(v); pinched != pinched_.end()) pinched->second.push_back(t);
    }
    for (int i = 0; i < 4; ++i) {
      Site::HoleFace& face = site.hole_face(face_of(made.vertex, i));
      tets_[t].label[i] = face.label;
      if (face.tet >= 0) {
        tets_[t].neighbour[i] = face.tet;
        tets_[face.tet].neighbour[face.face] = t;
      } else {
        face.tet = t;
        face.face = i;
      }
    }
  }
  const int more = static_cast<int>(filling.size()) - static_cast<int>(cavity.size());
  (&site == &own_ ? alive_ : site.more_) += more;
  return true;
}

std::vector<TetComplex::Site> TetComplex::part(const std::vector<int>& room) {
  std::vector<Site> sites(room.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    while (static_cast<int>(sites[i].free_.size()) < room[i]) {
      const int t = new_slot(own_);
      sites[i].free_.push_back(t);
    }
  return sites;
}

void TetComplex::rejoin(std::vector<Site>& sites) {
  for (auto site = sites.rbegin(); site != sites.rend(); ++site) {
    own_.free_.insert(own_.free_.end(), site->free_.begin(), site->free_.end());
    alive_ += site->more_;
  }
  sites.clear();
}

void TetComplex::renumber(const std::vector<int>& place) {
  std::vector<std::pair<int, int>> order;  // lowest vertex, slot
  order.reserve(alive_);
  for (int t = 0; t < slots(); ++t) {
    if (!tets_[t].alive()) continue;
    for (int& v : tets_[t].vertex) v = place[v];
    order.emplace_back(*std::min_element(tets_[t].vertex.begin(), tets_[t].vertex.end()), t);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> slot(tets_.size(), -1);
  std::vector<Tet> tets;
  tets.reserve(order.size());
  for (const auto& [lowest, t] : order) {
    slot[t] = static_cast<int>(tets.size());
    tets.push_back(tets_[t]);
  }
  for (Tet& tet : tets)
    for (int& t : tet.neighbour)
      if (t >= 0) t = slot[t];
  tets_ = std::move(tets);
  own_.free_.clear();

  std::vector<int> tet_of;
  tet_of.reserve(tet_of_.size());
  for (std::size_t v = 0; v < tet_of_.size(); ++v) {
    if (place[v] < 0) continue;
    if (place[v] >= static_cast<int>(tet_of.size())) tet_of.resize(place[v] + 1, -1);
    tet_of[place[v]] = tet_of_[v] < 0 ? -1 : slot[tet_of_[v]];
  }
  tet_of_ = std::move(tet_of);
  std::unordered_map<std::uint64_t, int> creases;
  for (const auto& [a, b, edge] : this->creases()) creases[key(place[a], place[b])] = edge;
  creases_ = std::move(creases);
  std::unordered_map<int, std::vector<int>> pinched;
  for (auto& [v, all] : pinched_) {
    for (int& t : all) t = slot[t];
    pinched[place[v]] = std::move(all);
  }
  pinched_ = std::move(pinched);
}

std::vector<std::array<int, 3>> TetComplex::creases() const {
  std::vector<std::array<int, 3>> list;
  list.reserve(creases_.size());
  for (const auto& [pair, edge] : creases_)
    list.push_back({static_cast<int>(pair >> 32), static_cast<int>(pair & 0xffffffffu), edge});
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace fgmesh
