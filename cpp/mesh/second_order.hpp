// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"
#include "core/second_order_mesh.hpp"

namespace fgmesh {

/// Gives a valid mesh a node in the middle of each edge: on the true edge or face that the mesh edge follows,
/// else halfway. The Jacobian determinant of every tetrahedron is proved to be above a tenth of what it is
/// with straight edges; edges that are in the way of that are half as curved or straight, and are listed in
/// SecondOrderMesh::straightened. Throws Cancelled.
SecondOrderMesh make_second_order(const TetMesh& mesh, const BoundaryGeometry& boundary, RunControl& control);

}  // namespace fgmesh
