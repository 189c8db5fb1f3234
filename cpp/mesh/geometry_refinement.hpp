// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "domain/sizing_field.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

struct GeometryRefinementOptions {
  double deviation = 0.0;  ///< largest distance of facet centres and crease middles to the true boundary, mm
  double min_size = 0.0;   ///< mm
  QualityGoal goal;
};

void refine_geometry(MeshState& state, const GeometryRefinementOptions& options, RunControl& control);

}  // namespace fgmesh
