// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/stage_report.hpp"
#include "core/tet_mesh.hpp"

namespace fgmesh {

/// Material composition variation of each tetrahedron from the fraction at each point.
std::vector<double> variations(const TetMesh& mesh, const std::vector<double>& fraction);

/// Smallest dihedral angle of each tetrahedron, degrees.
std::vector<double> smallest_dihedrals(const TetMesh& mesh);

/// Sum of the tetrahedra's volumes, mm^3.
double volume(const TetMesh& mesh);

/// The figures of the paper's table 1 and the histograms of its figures 7, 8 and 10. Variation is binned over
/// [0, 2 threshold] (more falls into the last bin), angles over [0, 180] degrees.
StageReport make_stage_report(const std::string& name, const TetMesh& mesh,
                              const std::vector<double>& fraction, double threshold);

}  // namespace fgmesh
