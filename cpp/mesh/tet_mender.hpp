// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/swap.hpp"

namespace fgmesh {

/// Improves tetrahedra that miss a goal one by one: by swaps of their edges and faces, then moves of their
/// vertices, then collapses of their edges, each kept only if the worst score around it rises (Klingner and
/// Shewchuk 2007). Frozen vertices stay in place.
class TetMender {
 public:
  /// `seed`: of the directions that moves are tried in.
  TetMender(MeshState& state, const TetScore& score, TetComplex::Site& site, std::uint32_t seed)
      : state_(state),
        score_(score),
        site_(site),
        swapper_(state, objective_, site, nullptr),
        random_(seed) {}

  TetMender(const TetMender&) = delete;
  TetMender& operator=(const TetMender&) = delete;

  /// Changes the tetrahedra at the vertices of tetrahedron t only. `may_insert`: also puts a new vertex into
  /// one that nothing else mends. Returns whether the worst score around it rose.
  bool mend(int t, bool may_insert);

  /// Looks for a better place of one vertex. Returns whether its star's worst score rose.
  bool improve_vertex(int v);

  /// A unit vector; the next of the sequence that the seed begins.
  Vec3 random_direction();

 private:
  bool collapse(int t);
  bool insert_vertex(int t);
  bool is_promising(int v, const Vec3& way, double best) const;
  double star_score(int v, const Vertex& moved, double stop_below) const;

  MeshState& state_;
  const TetScore& score_;
  TetComplex::Site& site_;
  const WorstScore objective_{score_};
  Swapper swapper_;
  std::vector<int> star_;
  std::uint32_t random_;
};

}  // namespace fgmesh
