// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

/// Raises angles far below the goal that no single change raises. Around each such tetrahedron something is
/// disturbed: an edge split or collapsed, vertices moved at random, whatever the angles become; then all
/// around is mended towards the goal. What came of it is kept where fewer or less bad angles are left and no
/// more tetrahedra above the threshold, and undone otherwise. Angles between two faces of the shape at their
/// edge are left alone. Returns how many tetrahedra were made better.
int raise_worst_angles(MeshState& state, const QualityGoal& goal, RunControl& control);

}  // namespace fgmesh
