// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/surface_remeshing.hpp"
#include "mesh/wall_thickness.hpp"

namespace fgmesh {

/// How far the middle of an edge of a triangle is off its crease or face.
double error_of(const SurfaceMesh& mesh, int a, int b, int face);

/// The size that the curvature along an edge allows whose middle is `error` off: by the deviation, and by how
/// far normals turn. Not below the least size: at a kink of a face, or where an edge and a face differ by
/// their tolerance, it would be nothing.
double curvature_size(double length, double error, const SurfaceRemeshingOptions& options);

/// Sizes that follow the curvature and may grow at a bounded rate.
void set_sizes(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control);

void limit_growth(SurfaceMesh& mesh, double growth, RunControl& control);

/// Lowers sizes where a wall is thin for the triangles on it: where these stray from a bent wall by a good
/// part of its thickness, tetrahedra could not be brought onto the true faces later; where they are much
/// longer than the wall is thick, tetrahedra are flat. Likewise where a face is narrow, such as a strip
/// between two fillets. Returns whether it lowered any.
bool refine_walls(SurfaceMesh& mesh, const WallThickness& walls, const SurfaceRemeshingOptions& options,
                  RunControl& control);

}  // namespace fgmesh
