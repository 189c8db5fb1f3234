// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "core/tet_mesh.hpp"
#include "quality/part_name.hpp"

namespace fgmesh {

/// No dihedral angle is to be smaller than this, degrees, but for those that the shape forces.
inline constexpr double kAngleGoal = 5.0;

/// The tetrahedra with a dihedral angle below kAngleGoal, by whether the shape forces it.
struct SmallAngles {
  /// Those that touch an edge whose faces meet below kAngleGoal, a vertex where two edges of a face do, or
  /// two sides of a wall thinner than the smallest size.
  std::vector<std::int32_t> forced;
  std::vector<std::int32_t> unforced;  ///< all others
  std::string sharpest;  ///< what forces them, for a reader: "the faces at Edge7 meet at 3 degrees ..."
};

/// `dihedral_min` is the smallest angle of each tetrahedron, degrees. Angles of the shape are measured
/// between its true faces and edges, not between facets.
SmallAngles find_small_angles(const TetMesh& mesh, const std::vector<double>& dihedral_min,
                              const BoundaryGeometry& boundary, double min_size, const PartName& name);

/// How many there are, where, and why; no message where there are none.
std::vector<std::string> describe(const SmallAngles& angles, const TetMesh& mesh,
                                  const std::vector<double>& dihedral_min);

}  // namespace fgmesh
