// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/swap.hpp"

namespace fgmesh {

/// Tries all edges and faces of the mesh once, some at the same time; returns how many were swapped.
int swap_pass(MeshState& state, const SwapObjective& objective, RunControl& control);

}  // namespace fgmesh
