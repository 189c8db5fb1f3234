// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brep/brep_model.hpp"
#include "pipeline/generate_mesh.hpp"

namespace fgmesh {

/// The default surface deviation is made so small that no solid's volume is farther off than this part of it.
inline constexpr double kVolumeGoal = 5e-3;

/// It is not made smaller than this for a part of so large a diagonal, mm.
inline double least_deviation(double diagonal) { return diagonal / 40000.0; }

/// What it becomes where it leaves so large an error of volume, mm.
double lowered_deviation(double deviation, double error, double diagonal);

/// Largest error of the volume of a solid in the mesh, as part of its volume.
double largest_volume_error(const TetMesh& mesh, const BrepModel& model);

/// Distance of the centre of each boundary triangle, curved where the mesh is, to its face, mm.
std::vector<double> facet_deviations(const MeshingResult& result, const BoundaryGeometry& boundary);

/// Throws GeometryError where the volume of a solid in the mesh differs by more from the true one than its
/// facets, each as far off as `deviations` says, can explain: a part of the solid was lost.
void require_explained_volumes(const MeshingResult& result, const std::vector<double>& deviations,
                               const BrepModel& model);

/// Puts the volumes of the mesh and of the shape, in all and by the SolidN of the shape given, and a message
/// for each that misses kVolumeGoal.
void put_volumes(const BrepModel& model, MeshingResult& result);

}  // namespace fgmesh
