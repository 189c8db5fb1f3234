// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

struct InitialMeshOptions {
  double size = 0.0;       ///< of edges, facets and cells, mm
  double deviation = 0.0;  ///< of facets from the samples, mm
  unsigned seed = 0;       ///< of CGAL's random choices; the same seed gives the same mesh
};

/// Initial mesh (paper, section 2.2): a coarse Delaunay mesh of the sampled boundary by CGAL, its creases and
/// corners protected, its boundary vertices brought onto the true surface. No material is involved. Where
/// details of the shape are lost a finer mesh is tried. Throws GeometryError where none is found.
void make_initial_mesh(MeshState& state, const SampledBoundary& samples, const InitialMeshOptions& options,
                       RunControl& control);

}  // namespace fgmesh
