// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/material_refinement.hpp"

#include "mesh/edge_split.hpp"
#include "mesh/odt_smoothing.hpp"
#include "mesh/steiner_points.hpp"
#include "mesh/threshold_relaxation.hpp"
#include "mesh/worst_first.hpp"

namespace fgmesh {
namespace {

void smooth(MeshState& state, const MaterialRefinementOptions& options, int sweeps, double damping,
            RunControl& control) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    update_sizes(state, options.sizing);
    odt_sweep(state, damping, control);
  }
}

/// The paper's loop: Steiner points, ODT smoothing, evaluation. It ends when a round finds hardly a
/// tetrahedron above `limit` any more: when it adds less than `done` points a tetrahedron.
void grow(MeshState& state, const MaterialRefinementOptions& options, double limit, double done,
          RunControl& control) {
  constexpr int kMostRounds = 200;
  // Memory is in order as long as the mesh has not grown by this factor.
  constexpr double kGrown = 1.5;
  constexpr std::size_t kMany = 16384;  // vertices; fewer fit into caches
  constexpr double kLong = 1.1;         // what is a little longer than MaxSize may still be mended
  std::size_t sorted = kMany;
  for (int round = 0; round < kMostRounds; ++round) {
    if (state.vertices.size() > kGrown * sorted) {
      state.sort_by_place();
      sorted = state.vertices.size();
    }
    control.report(0.6 * round / (round + 8.0), state.complex.tet_count());
    resolve_boundary(state, control);
    const int room = std::max(0, options.most_tets - state.complex.tet_count());
    int inserted = insert_steiner_points(state, limit, room, control);
    if (room > 0) inserted += split_long_edges(state, kLong * options.goal.longest_edge, control);
    if (inserted <= done * state.complex.tet_count()) break;
    smooth(state, options, options.growth_sweeps, 1.0, control);
  }
}

/// Where growing ends few tetrahedra are far above the threshold. Where many are a little above, no moves
/// help: adds points until there are as few as relaxation copes with.
void thicken(MeshState& state, const MaterialRefinementOptions& options, RunControl& control) {
  const double limit = 1.2 * state.threshold();
  constexpr int kMostRounds = 20;
  constexpr double kMany = 0.15;  // of the tetrahedra
  constexpr int kRelieved = 8;    // tetrahedra that a point relieves
  for (int round = 0; round < kMostRounds; ++round) {
    const int above = count_divisible(state, limit);
    if (above < kMany * state.complex.tet_count() || state.complex.tet_count() >= options.most_tets) break;
    if (insert_steiner_points(state, limit, above / kRelieved, control) == 0) break;
    smooth(state, options, options.growth_sweeps, 1.0, control);
  }
}

/// Sweeps of threshold relaxation, with a damped ODT sweep now and then that keeps shapes good.
void relax(MeshState& state, const MaterialRefinementOptions& options, RunControl& control) {
  constexpr int kSweepsBetween = 15;
  for (int sweep = 1; sweep <= options.relaxations; ++sweep) {
    if (sweep % kSweepsBetween == 0) smooth(state, options, 1, 0.5, control);
    relax_threshold(state, options.relaxation_aim * state.threshold(), control);
  }
}

}  // namespace

void refine_material(MeshState& state, const MaterialRefinementOptions& options, RunControl& control) {
  control.report(0.0, state.complex.tet_count());
  smooth(state, options, options.growth_sweeps, 1.0, control);
  if (options.points_only) {
    grow(state, options, state.threshold(), 0.0, control);
    while (split_long_edges(state, options.goal.longest_edge, control) > 0) {
    }
    return;
  }
  grow(state, options, options.growth_limit * state.threshold(), options.growth_done, control);
  thicken(state, options, control);
  smooth(state, options, options.final_sweeps, 1.0, control);

  const TetScore score(state, options.goal);
  WorstFirst mender(state, score);
  constexpr int kMostRounds = 20;
  constexpr int kBarredRounds = 4;   // where no point may be put into most of those above
  constexpr double kMany = 0.002;    // of the tetrahedra; fewer than that are mended better one by one
  constexpr double kTooMany = 0.45;  // more than that are not worth mending before there are more points
  constexpr int kShare = 32;         // of so many tetrahedra one gets a point then
  const auto count = [&] { return count_divisible(state, state.threshold()); };
  for (int round = 0; round < kMostRounds && state.complex.tet_count() < options.most_tets; ++round) {
    int above = count();
    if (round >= kBarredRounds && count_above(state, state.threshold()) > 2 * above) break;
    if (round == 0 || above > kMany * state.complex.tet_count()) {
      relax(state, options, control);
      above = count();
    }
    // Only into a part of the tetrahedra: each point relieves its neighbours too.
    int points = above / kShare;
    const bool are_too_many = above > kTooMany * state.complex.tet_count();
    if (!are_too_many) {
      if (mender.run(3, control) == 0) break;
      points = std::max(8, count() / 4);
    }
    control.report(0.6 + 0.4 * (round + 1) / kMostRounds, state.complex.tet_count());
    int added = insert_steiner_points(state, state.threshold(), points, control);
    if (!are_too_many) added += split_long_edges(state, options.goal.longest_edge, control);
    if (added == 0) break;
    if (are_too_many) smooth(state, options, options.growth_sweeps, 1.0, control);
  }
  mender.run(10, control);
}

}  // namespace fgmesh
