// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/run_control.hpp"
#include "domain/graded_sizes.hpp"
#include "domain/sizing_field.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Tetrahedra in a cube of the edge `size` of an initial mesh, where no boundary is near: measured on a box
/// (22.1) and on balls and cylinders whose MaxSize is small (21 to 23).
inline constexpr double kInitialTets = 22.0;

/// What is wanted of a mesh.
struct WantedMesh {
  bool material = true;  ///< whether the threshold counts
  double threshold = 0.1;
  SizingField sizing;              ///< of the material-oriented refinement
  double max_size = 0.0;           ///< of the initial mesh, mm; not looked at where the one at hand is that
  GradedSizes initial{{}, 1.0};    ///< of the initial mesh at the boundary, likewise
  GradedSizes deviation{{}, 1.0};  ///< of the geometry-oriented refinement
};

/// How many tetrahedra will be in place of the initial mesh `state`. Its tetrahedra are divided where many
/// are expected, and the density that is wanted is summed up. Ends whatever f does; throws what
/// MeshState::evaluate() throws, and Cancelled.
double expected_tets(const MeshState& state, const WantedMesh& wanted, RunControl& control);

}  // namespace fgmesh
