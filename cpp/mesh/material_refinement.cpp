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

/// The paper's loop: Steiner points, ODT smoothing, evaluation. It ends when the density is right: when a
/// round finds hardly a tetrahedron above growth_limit thresholds any more.
void grow(MeshState& state, const MaterialRefinementOptions& options, RunControl& control) {
  const double limit = options.growth_limit * state.threshold();
  constexpr int kMostRounds = 60;
  constexpr double kDone = 0.002;  // new points a tetrahedron
  for (int round = 0; round < kMostRounds; ++round) {
    control.report(0.6 * round / (round + 8.0), state.complex.tet_count());
    resolve_boundary(state, options.sizing.min_size, control);
    const int room = std::max(0, options.most_tets - state.complex.tet_count());
    const int inserted = insert_steiner_points(state, limit, options.sizing.min_size, room, control);
    if (inserted < kDone * state.complex.tet_count()) break;
    smooth(state, options, options.growth_sweeps, 1.0, control);
  }
}

/// Threshold relaxation in `sweeps` sweeps, with a damped ODT sweep now and then that keeps shapes good.
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
  grow(state, options, control);
  smooth(state, options, options.final_sweeps, 1.0, control);

  const TetScore score(state, options.goal);
  WorstFirst mender(state, score);
  constexpr int kMostRounds = 20;
  constexpr double kMany = 0.002;  // of the tetrahedra; fewer than that are mended better one by one
  for (int round = 0; round < kMostRounds; ++round) {
    if (round == 0 || count_above(state, state.threshold()) > kMany * state.complex.tet_count())
      relax(state, options, control);
    const int left = mender.run(3, control);
    const int above = count_above(state, state.threshold());
    control.report(0.6 + 0.4 * (round + 1) / kMostRounds, state.complex.tet_count());
    if (left == 0 || state.complex.tet_count() >= options.most_tets) break;
    // Only into a part of them: each point relieves its neighbours too.
    const std::size_t most = std::max(8, above / 4);
    if (insert_steiner_points(state, state.threshold(), options.sizing.min_size, most, control) == 0) break;
  }
  mender.run(10, control);
}

}  // namespace fgmesh
