// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run_control.hpp"
#include "mesh/surface_mesh.hpp"

namespace fgmesh {

/// Bridges what is narrower than `size`, mm: steps, small fillets and chamfers, tiny edges. The vertices on
/// both sides become one, and the triangles between them vanish. Walls and slots stay, however thin. Returns
/// the vertices, edges and faces of the shape that have, or may have, lost elements, each once.
std::vector<Carrier> bridge_small_features(SurfaceMesh& mesh, double size, RunControl& control);

}  // namespace fgmesh
