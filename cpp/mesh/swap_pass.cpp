// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/swap_pass.hpp"

#include <numeric>

#include "mesh/blocks.hpp"

namespace fgmesh {
namespace {

/// One pass over the mesh, by blocks.
class SwapPass {
 public:
  SwapPass(MeshState& state, const SwapObjective& objective, RunControl& control)
      : state_(state), objective_(objective), control_(control), blocks_(state) {}

  int run() {
    int count = 0;
    for (int cut = 0; cut < blocks_.last_cut(); ++cut) count += swap_at_once(cut);
    return count + swap_rest();
  }

 private:
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  int swap_at_once(int cut) {
    TetComplex& complex = state_.complex;
    std::vector<std::vector<int>> members(blocks_.count(cut));
    for (int t = 0; t < complex.slots(); ++t) {
      if (!complex.tet(t).alive() || is_done(complex.tet(t), cut)) continue;
      const int block = blocks_.around(cut, complex.tet(t).vertex);
      if (block >= 0) members[block].push_back(t);
    }
    // Swaps make as many tetrahedra as they remove, more or less.
    std::vector<int> room;
    for (const std::vector<int>& tets : members) room.push_back(32 + static_cast<int>(tets.size()) / 16);
    std::vector<TetComplex::Site> sites = complex.part(room);
    costs_.resize(complex.slots(), kUnknown);
    std::vector<int> counts(members.size(), 0);
    for_each_at_once(static_cast<int>(members.size()), [&](int block) {
      const std::vector<int> made = TetComplex::free_slots(sites[block]);
      members[block].insert(members[block].end(), made.begin(), made.end());
      Swapper swapper(state_, objective_, sites[block], &costs_);
      for (std::size_t i = 0; i < members[block].size(); ++i) {
        if (i % 1024 == 0) control_.check();
        counts[block] += swap_around(members[block][i], swapper, cut);
      }
    });
    complex.rejoin(sites);
    return std::accumulate(counts.begin(), counts.end(), 0);
  }

  int swap_rest() {
    const TetComplex& complex = state_.complex;
    costs_.resize(complex.slots(), kUnknown);
    Swapper swapper(state_, objective_, state_.complex.own_site(), &costs_);
    int count = 0;
    for (int t = 0; t < complex.slots(); ++t) {
      if (t % 1024 == 0) control_.check();
      if (!is_done(complex.tet(t), blocks_.last_cut())) count += swap_around(t, swapper, blocks_.last_cut());
    }
    return count;
  }

  int swap_around(int t, Swapper& swapper, int cut) {
    const TetComplex& complex = state_.complex;
    int count = 0;
    for (int face = 0; face < 4 && complex.tet(t).alive(); ++face) {
      const Tet& tet = complex.tet(t);
      if (t < tet.neighbour[face] && is_due(tet.vertex, complex.tet(tet.neighbour[face]).vertex, cut))
        count += swapper.remove_face(t, face);
    }
    for (int e = 0; e < 6 && complex.tet(t).alive(); ++e) {
      const int a = complex.tet(t).vertex[kEdgeVertices[e][0]],
                b = complex.tet(t).vertex[kEdgeVertices[e][1]];
      if (blocks_.was_inner(cut, a) || blocks_.was_inner(cut, b) ||
          !complex.ring_of_first(a, b, t, swapper.ring()))
        continue;
      if (is_due(std::array{a, b}, swapper.ring().link, cut)) count += swapper.remove_ringed_edge(a, b);
    }
    return count;
  }

  /// Whether each edge and each face of the tetrahedron has a vertex that was inside a block before.
  bool is_done(const Tet& tet, int cut) const {
    int inner = 0;
    for (int v : tet.vertex) inner += blocks_.was_inner(cut, v);
    return inner >= 3;
  }
  /// Whether what has these vertices is within a block of this cut, and was not of an earlier one.
  template <class Some, class Others>
  bool is_due(const Some& some, const Others& others, int cut) const {
    const auto is_within = [&](int which) {
      const int block = blocks_.around(which, some);
      return block >= 0 && block == blocks_.around(which, others);
    };
    for (int earlier = 0; earlier < cut; ++earlier)
      if (is_within(earlier)) return false;
    return cut == blocks_.last_cut() || is_within(cut);
  }

  MeshState& state_;
  const SwapObjective& objective_;
  RunControl& control_;
  const Blocks blocks_;
  std::vector<double> costs_;
};

}  // namespace

int swap_pass(MeshState& state, const SwapObjective& objective, RunControl& control) {
  return SwapPass(state, objective, control).run();
}

}  // namespace fgmesh
