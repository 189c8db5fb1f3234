// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/tet_score.hpp"

namespace fgmesh {

/// Removes an inner vertex by drawing it onto its neighbour `target`, if every tetrahedron made
/// scores at least `least` and varies by at most `variation`. Returns whether it did.
bool collapse_edge(MeshState& state, int vertex, int target, const TetScore& score, double least,
                   double variation);

}  // namespace fgmesh
