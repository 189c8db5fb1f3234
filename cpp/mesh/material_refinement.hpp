// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/run_control.hpp"
#include "domain/sizing_field.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

struct MaterialRefinementOptions {
  SizingField sizing;
  QualityGoal goal;
  int most_tets = 20000000;  ///< no Steiner points once the mesh has as many

  /// Points until none is above, as in the paper, in place of relaxation and mending.
  bool points_only = false;

  int growth_sweeps = 3;       ///< ODT sweeps after each round of Steiner points
  double growth_limit = 1.4;   ///< rounds of Steiner points go on until no tet is above this many thresholds,
  double growth_done = 0.002;  ///< or a round has added less than so many points a tetrahedron
  int final_sweeps = 20;       ///< ODT sweeps once the density is right
  int relaxations = 30;        ///< sweeps of threshold relaxation between insertions
  double relaxation_aim = 0.93;  ///< of the threshold
};

/// Material-oriented refinement (paper, section 2.3): Steiner points into the tetrahedra above the threshold,
/// ODT smoothing with the sizing field of equation 2.7, and again, until none is above; then the last few are
/// mended one by one. Tetrahedra across a jump of f, or whose edges would fall below MeshState::min_size,
/// stay above.
void refine_material(MeshState& state, const MaterialRefinementOptions& options, RunControl& control);

}  // namespace fgmesh
