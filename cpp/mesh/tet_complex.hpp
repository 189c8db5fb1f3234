// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace fgmesh {

/// One tetrahedron with its neighbours. Face i is opposite vertex i (see kFaceVertices).
struct Tet {
  std::array<int, 4> vertex{};
  std::array<int, 4> neighbour{-1, -1, -1, -1};  ///< across face i; -1: the outside
  std::array<int, 4> label{};                    ///< FaceN that face i is part of; 0: inside a solid
  int solid = 0;                                 ///< SolidN; 0: this slot is free

  bool alive() const { return solid != 0; }
  int index_of(int v) const {
    return vertex[0] == v ? 0 : vertex[1] == v ? 1 : vertex[2] == v ? 2 : vertex[3] == v ? 3 : -1;
  }
  bool has(int v) const { return index_of(v) >= 0; }
};

/// A labelled triangle of the boundary or of an interface.
struct LabelledFacet {
  std::array<int, 3> vertex{};
  int label = 0;
};

/// A tetrahedron about to be made.
struct NewTet {
  std::array<int, 4> vertex{};
  int solid = 0;
};

/// The tetrahedra around an edge, in order. link[i] and link[i + 1] are the other two vertices of tet[i];
/// where the ring is closed link has as many entries as tet and wraps around, else one more.
struct EdgeRing {
  std::vector<int> tet;
  std::vector<int> link;
  bool closed = false;
};

/// The connectivity of a tetrahedral mesh in progress: neighbours, labels, crease edges. It knows no
/// coordinates. Every change is one cavity of tetrahedra replaced by another filling of the same
/// hole, so that one function keeps everything consistent.
class TetComplex {
 public:
  /// Builds all neighbours anew. `facets` labels the boundary and the interfaces. Throws GeometryError
  /// where the tetrahedra do not form a complex (a face of three tetrahedra, a boundary face without label).
  void build(const std::vector<NewTet>& tets, const std::vector<LabelledFacet>& facets, int vertex_count);

  /// One past the highest slot; slots may be free (see Tet::alive).
  int slots() const { return static_cast<int>(tets_.size()); }
  int tet_count() const { return alive_; }
  const Tet& tet(int t) const { return tets_[t]; }

  int vertex_slots() const { return static_cast<int>(tet_of_.size()); }
  /// Some tetrahedron at vertex v; -1 where there is none.
  int tet_at(int v) const { return tet_of_[v]; }
  int add_vertex() {
    tet_of_.push_back(-1);
    return vertex_slots() - 1;
  }

  /// All tetrahedra at vertex v, in `star` (its old content is dropped).
  void star(int v, std::vector<int>& star) const;

  /// True where the tetrahedra at v fall into parts that have no face in common: solids touch themselves or
  /// each other there.
  bool is_pinched(int v) const { return pinched_.count(v) > 0; }
  /// Says so of a vertex that the last replace() has made.
  void pinch(int v);

  /// The ring of edge (a, b), which tetrahedron t has. Where solids touch along the edge, one part of it.
  void ring(int a, int b, int t, EdgeRing& ring) const;
  /// The same if the ring has at most `most` tetrahedra. Else false, and what `ring` holds is of no use: some
  /// edges beside very fine parts of the boundary have thousands.
  bool small_ring(int a, int b, int t, std::size_t most, EdgeRing& ring) const;
  /// The same if t is the first, by its slot, of the ring. Else false, and what `ring` holds is of no use:
  /// who asks for the edges of all tetrahedra gets each ring once, and gives the others up early.
  bool ring_of_first(int a, int b, int t, EdgeRing& ring) const;

  /// Some tetrahedron that has the edge (a, b); -1 where the mesh has no such edge.
  int find_edge(int a, int b) const;

  /// What one who changes the mesh needs of their own: free slots, and scratch space. Several may change it
  /// at the same time, each in a thread, if no tetrahedron in a cavity of one has a vertex in common with one
  /// in a cavity of another, and no vertex is pinched. See part().
  class Site {
   public:
    /// The tetrahedra made by the last replace().
    const std::vector<int>& created() const { return created_; }

   private:
    friend class TetComplex;
    // A face of the hole that replace() fills: who stands behind it, and with which label.
    struct HoleFace {
      std::array<int, 3> vertex;  // sorted
      int tet = -1, face = -1;    // the tetrahedron that waits for a neighbour here; -1: only a label
      int label = 0;
    };
    HoleFace& hole_face(std::array<int, 3> vertices);

    std::vector<int> free_;
    bool may_grow_ = false;
    int more_ = 0;  // tetrahedra made beyond those removed
    std::vector<int> created_;
    std::vector<HoleFace> hole_;
    std::vector<int> hole_table_;  // open addressing into hole_; its size is a power of two
  };

  /// Removes the tetrahedra `cavity` and fills the hole with `filling`. Labels on the hole's outer faces
  /// stay; `facets` are the labelled triangles that lie inside the cavity or on its part of the boundary
  /// afterwards. The caller has made sure that the filling fits. False, and nothing is changed, where the
  /// site has not slots enough.
  bool replace(const std::vector<int>& cavity, const std::vector<NewTet>& filling,
               const std::vector<LabelledFacet>& facets, Site& site);
  /// The same at the site of those who work alone, which never lacks slots.
  void replace(const std::vector<int>& cavity, const std::vector<NewTet>& filling,
               const std::vector<LabelledFacet>& facets) {
    replace(cavity, filling, facets, own_);
  }
  Site& own_site() { return own_; }

  /// Renumbers the vertices, `place[v]` is the new number of v, -1 drops one that is in no tetrahedron; and
  /// the tetrahedra in the order of their lowest vertices, without free slots between them.
  void renumber(const std::vector<int>& place);

  /// The tetrahedra made by the last replace() at the own site.
  const std::vector<int>& created() const { return own_.created(); }

  /// Sites for work at the same time, with `room[i]` free slots each; to be given back by rejoin() before any
  /// other change. Until then tet_count() knows nothing of what they do.
  std::vector<Site> part(const std::vector<int>& room);
  void rejoin(std::vector<Site>& sites);
  /// The slots that are free at a site, in the order in which it takes them.
  static std::vector<int> free_slots(const Site& site) { return {site.free_.rbegin(), site.free_.rend()}; }

  /// EdgeN that the mesh edge (a, b) follows; 0: none.
  int crease(int a, int b) const {
    const auto found = creases_.find(key(a, b));
    return found == creases_.end() ? 0 : found->second;
  }
  void set_crease(int a, int b, int edge) { creases_[key(a, b)] = edge; }
  void clear_crease(int a, int b) { creases_.erase(key(a, b)); }
  /// Labels face i of tetrahedron t, from both sides.
  void set_label(int t, int i, int label) {
    tets_[t].label[i] = label;
    const int other = tets_[t].neighbour[i];
    if (other < 0) return;
    for (int k = 0; k < 4; ++k)
      if (tets_[other].neighbour[k] == t) tets_[other].label[k] = label;
  }
  /// Every crease edge (a < b) with its EdgeN, sorted.
  std::vector<std::array<int, 3>> creases() const;

 private:
  static std::uint64_t key(int a, int b) {
    if (a > b) std::swap(a, b);
    return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b);
  }
  template <class Accept>
  bool walk_ring(int a, int b, int t, EdgeRing& ring, const Accept& accept) const;
  int new_slot(Site& site);
  void find_pinched();

  std::vector<Tet> tets_;
  std::vector<int> tet_of_;
  std::unordered_map<int, std::vector<int>> pinched_;  // all tetrahedra of each
  std::unordered_map<std::uint64_t, int> creases_;
  int alive_ = 0;
  Site own_;
};

}  // namespace fgmesh
