// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "core/tet_mesh.hpp"
#include "quality/part_name.hpp"

namespace fgmesh {

/// Where the boundary of a mesh is put together otherwise than the samples that it was made from, in words;
/// empty where nowhere: each FaceN and EdgeN has elements, in as many pieces and with as many holes and
/// handles (Euler characteristic) as its samples. Not asked of those in `bridged`.
std::string find_difference(const TetMesh& mesh, const SampledBoundary& samples,
                            const std::vector<Carrier>& bridged, const PartName& name);

}  // namespace fgmesh
