// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/stage_report.hpp"
#include "core/tet_mesh.hpp"

namespace fgmesh {

/// Smallest dihedral angle of each tetrahedron, degrees.
std::vector<double> smallest_dihedrals(const TetMesh& mesh);

/// Volume of each tetrahedron, mm^3.
std::vector<double> tet_volumes(const TetMesh& mesh);

/// Sum of the tetrahedra's volumes, mm^3.
double volume(const TetMesh& mesh);

/// The figures of the paper's table 1 and the histograms of its figures 7, 8 and 10. Variation is binned over
/// [0, 2 threshold] (more falls into the last bin), angles over [0, 180] degrees. `variation` holds that of
/// each tetrahedron.
StageReport make_stage_report(const std::string& name, const TetMesh& mesh,
                              const std::vector<double>& variation, double threshold);

}  // namespace fgmesh
