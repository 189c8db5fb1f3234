// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "mesh/surface_mesh.hpp"
#include "mesh/wall_thickness.hpp"

namespace fgmesh {

struct SurfaceRemeshingOptions {
  double size = 0.0;       ///< of the triangles where nothing asks for less, mm
  double deviation = 0.0;  ///< largest distance of the middle of an edge to the true surface, mm
  double growth = 0.5;     ///< how fast triangles may grow, mm a mm
  double min_size = 0.0;  ///< smaller triangles come only from short edges of the shape, mm; in thinner walls
                          ///< they may be long
};

/// Makes a coarse triangulation of well-shaped triangles out of the fine samples: edges are split, collapsed
/// and flipped, vertices move on the true surface (Botsch and Kobbelt 2004). Creases, corners and faces stay.
/// Triangles on bent walls are small enough for both sides of the wall to stay apart. Leaves the size wanted
/// at each vertex in Vertex::size.
void remesh_surface(SurfaceMesh& mesh, const WallThickness& walls, const SurfaceRemeshingOptions& options,
                    RunControl& control);

/// Flips edges inside faces until the triangles are Delaunay, as far as the true surface allows.
void make_surface_delaunay(SurfaceMesh& mesh, RunControl& control);

}  // namespace fgmesh
