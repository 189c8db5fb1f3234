// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_set>

#include "core/run_control.hpp"
#include "mesh/tet_mender.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

/// Local improvement of the tetrahedra that miss a goal, worst first, by a TetMender.
class WorstFirst {
 public:
  WorstFirst(MeshState& state, const TetScore& score)
      : state_(state),
        score_(score),
        shape_(state, {score.goal().smallest_angle, score.goal().largest_angle, false}),
        alone_(state, score, state.complex.own_site(), seeds_++) {}

  /// Goes over all tetrahedra that score below 1, at most `rounds` times. Returns how many are left.
  int run(int rounds, RunControl& control);

  /// Also puts a new vertex into a tetrahedron that nothing else mends, where that raises the worst
  /// score around it.
  void allow_insertion() {
    may_insert_ = true;
    hopeless_.clear();
  }

  /// The tetrahedra that score below `least`, worst first; but for those that no move mends.
  std::vector<int> bad_tets(double least = 1.0) const;

 private:
  struct Outcome {
    bool any = false;                   // was mended
    std::vector<std::size_t> hopeless;  // surroundings of those that could not be
  };

  template <class IsDue>
  Outcome mend(const std::vector<int>& tets, TetMender& mender, bool all_hope, const IsDue& is_due,
               RunControl& control) const;
  std::vector<int> mend_at_once(const std::vector<int>& bad, bool& any, RunControl& control);
  bool may_be_mended(int t) const;
  bool note(const Outcome& outcome);
  std::size_t surroundings(int t) const;

  MeshState& state_;
  const TetScore& score_;
  const TetScore shape_;  // the angles alone
  std::uint32_t seeds_ = 12345;
  TetMender alone_;
  bool may_insert_ = false;
  std::unordered_set<std::size_t> hopeless_;  // surroundings of tetrahedra that could not be mended
};

}  // namespace fgmesh
