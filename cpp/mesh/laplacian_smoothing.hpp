// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

/// One sweep of Laplacian smoothing over the vertices that are not frozen (paper, section 2.4): each goes to
/// the mean of its neighbours, on a face of those on the same face or its rim, on an edge of those along it;
/// kept only where the worst shape around it does not fall below what it was, or `floor`, and no tetrahedron
/// comes above the threshold.
void laplacian_sweep(MeshState& state, const TetScore& shape, double floor, RunControl& control);

}  // namespace fgmesh
