// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/geometry_refinement.hpp"

namespace fgmesh {

void refine_geometry(MeshState&, const GeometryRefinementOptions&, RunControl&) {}

}  // namespace fgmesh
