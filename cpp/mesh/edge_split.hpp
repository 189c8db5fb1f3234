// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Splits the edge (a, b), which tetrahedron t has, by a new vertex half-way, on the edge's carrier.
/// Returns the vertex; -1 where that would turn a tetrahedron over: no vertex was added then, but inner ones
/// may have made way, so that a later call gets farther.
int split_edge(MeshState& state, int a, int b, int t);

/// Splits boundary edges until none is farther from the true boundary than allowed_chord_error(), or would
/// become shorter than min_size. Returns how many were split.
int resolve_boundary(MeshState& state, double min_size, RunControl& control);

}  // namespace fgmesh
