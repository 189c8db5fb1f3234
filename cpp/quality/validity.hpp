// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/tet_mesh.hpp"

namespace fgmesh {

/// What is wrong with a mesh, in words; empty where nothing is: tetrahedra positively oriented, faces shared
/// by at most two of them, the boundary closed and equal to the labelled triangles (outward, each once),
/// indices in range, no point twice or unused, one solid and one face number for each element, edges that are
/// mesh edges.
std::string find_fault(const TetMesh& mesh);

}  // namespace fgmesh
