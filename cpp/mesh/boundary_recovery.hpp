// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/surface_mesh.hpp"

namespace fgmesh {

/// Fills the solids that a surface bounds with tetrahedra: the Delaunay triangulation of its vertices (CGAL),
/// in which missing edges and triangles of the surface are brought about by swaps, and where those fail by
/// splitting the surface on the true boundary. `state` gets the vertices of the surface by the same numbers.
/// Throws GeometryError where some of the surface cannot be recovered: then it cuts itself.
void tetrahedralize(MeshState& state, SurfaceMesh& surface, RunControl& control);

}  // namespace fgmesh
