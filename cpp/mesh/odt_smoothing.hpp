// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "domain/sizing_field.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Fills Vertex::size with the sizing field, its growth limited along the mesh's edges, and Vertex::stretch.
void update_sizes(MeshState& state, const SizingField& sizing);

/// Where optimal Delaunay triangulation wants vertex `v`: the mean of the circumcentres around it, weighted
/// by measure over mu^n (paper, equation 2.6 with n = 3 inside a solid; the same with triangles on a face and
/// with segments on an edge). `star` holds the tetrahedra at v.
Vec3 odt_target(const MeshState& state, int v, const std::vector<int>& star);

/// One sweep of ODT smoothing: each vertex goes the part `damping` of the way to its target, less far where
/// that would turn a tetrahedron over or flatten it. Boundary vertices stay on their face or edge, corners in
/// place. Then swaps lead back to a Delaunay triangulation.
void odt_sweep(MeshState& state, double damping, RunControl& control);

}  // namespace fgmesh
