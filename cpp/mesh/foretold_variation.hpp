// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Variation of the composition over the whole of a tetrahedron, as its values and gradients at the corners
/// foretell it: exact, but for places between those looked at, where the fractions are quadratic. Never below
/// variation(), and no more than that at interfaces.
double foretold_variation(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d);

}  // namespace fgmesh
