// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/boundary_geometry.hpp"

namespace fgmesh::brep {

/// Removes triangles whose corners lie on a line, by flipping their longest side with the neighbour of the
/// same face. They appear beside straight edges that end at the tip of a cone, where several (u, v) are one
/// point.
void flip_flat_triangles(SampledBoundary& boundary);

}  // namespace fgmesh::brep
