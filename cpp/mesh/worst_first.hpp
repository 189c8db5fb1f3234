// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_set>

#include "core/run_control.hpp"
#include "mesh/swap.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

/// Local improvement of the tetrahedra that miss a goal, worst first: swaps of their edges and faces, then
/// moves of their vertices, then collapses of their edges, each kept only if the worst score around it rises
/// (Klingner and Shewchuk 2007). Frozen vertices stay in place.
class WorstFirst {
 public:
  WorstFirst(MeshState& state, const TetScore& score) : state_(state), score_(score) {}

  /// Goes over all tetrahedra that score below 1, at most `rounds` times. Returns how many are left.
  int run(int rounds, RunControl& control);

  /// Also puts a new vertex into a tetrahedron that nothing else mends, where that raises the worst
  /// score around it.
  void allow_insertion() {
    may_insert_ = true;
    hopeless_.clear();
  }

  /// Looks for a better place of one vertex. Returns whether its star's worst score rose.
  bool improve_vertex(int v);

  /// The tetrahedra that score below `least`, worst first.
  std::vector<int> bad_tets(double least = 1.0) const;

 private:
  bool mend(int t, Swapper& swapper);
  std::size_t surroundings(int t) const;
  bool collapse(int t);
  bool insert_vertex(int t);
  Vec3 random_direction();
  bool is_promising(int v, const Vec3& way, double best) const;
  double star_score(int v, const Vertex& moved, double stop_below) const;

  MeshState& state_;
  const TetScore& score_;
  std::vector<int> star_;
  std::uint32_t random_ = 12345;
  bool may_insert_ = false;
  std::unordered_set<std::size_t> hopeless_;  // surroundings of tetrahedra that could not be mended
};

}  // namespace fgmesh
