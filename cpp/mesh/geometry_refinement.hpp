// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

struct GeometryRefinementOptions {
  double deviation = 0.0;  ///< largest distance of facet centres and crease middles to the true boundary, mm
  double growth = 0.6;     ///< how fast elements may grow from the boundary inwards, mm a mm
  QualityGoal goal;
};

/// Geometry-oriented refinement (paper, section 2.4): boundary facets and crease edges farther from the true
/// boundary than the deviation are split and brought onto it, the mesh inside is graded towards them, new
/// vertices are smoothed; M-vertices stay. Then the threshold and the angles are checked and mended; only
/// there may an M-vertex move, unless it is frozen, and only where that takes no tetrahedron above the
/// threshold.
void refine_geometry(MeshState& state, const GeometryRefinementOptions& options, RunControl& control);

/// Distance of the centre of a labelled face of tetrahedron t to the true face, mm.
double facet_deviation(const MeshState& state, int t, int face);

}  // namespace fgmesh
