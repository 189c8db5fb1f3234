// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Splits the edge (a, b), which tetrahedron t has, by a new vertex half-way, on the edge's carrier.
/// Returns the vertex; -1 where that would turn a tetrahedron over, and then nothing has changed.
int split_edge(MeshState& state, int a, int b, int t);

}  // namespace fgmesh
