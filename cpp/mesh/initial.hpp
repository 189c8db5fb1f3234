// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

struct InitialMeshOptions {
  double size = 0.0;       ///< of edges, mm; edges 1.5 times longer are split
  double deviation = 0.0;  ///< of the middles of boundary edges from the true boundary, mm
  double min_size = 0.0;   ///< of edges, mm; in thinner walls elements may be flat
  double bridged = 0.0;    ///< steps, fillets and edges of the shape that are smaller are bridged, mm
};

/// Initial mesh (paper, section 2.2): the samples are remeshed into a coarse surface on the true boundary,
/// which is filled by CGAL's Delaunay triangulation of its vertices; creases, corners and faces are kept
/// exactly, but for those of features that are bridged. No material is involved. Where that fails a finer
/// mesh is tried. Throws GeometryError where none is found. Returns the parts of the shape that may have lost
/// elements by bridging.
std::vector<Carrier> make_initial_mesh(MeshState& state, const SampledBoundary& samples,
                                       const InitialMeshOptions& options, RunControl& control);

}  // namespace fgmesh
