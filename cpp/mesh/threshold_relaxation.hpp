// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// One sweep of threshold relaxation: in each tetrahedron that varies by more than `aim` the vertices with
/// the highest and the lowest f go towards each other along the gradient, each by half the excess over |grad
/// f|; a vertex of several such tetrahedra goes the mean way. No tetrahedron is turned over or flattened, and
/// none becomes the worst of its star. Returns how many tetrahedra were above the threshold before.
int relax_threshold(MeshState& state, double aim, RunControl& control);

}  // namespace fgmesh
