// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/run_control.hpp"
#include "core/scalar_field.hpp"
#include "core/second_order_mesh.hpp"
#include "core/stage_report.hpp"
#include "core/tet_mesh.hpp"
#include "pipeline/meshing_options.hpp"

namespace fgmesh {

struct MeshingResult {
  TetMesh mesh;                      ///< four-node tetrahedra
  SecondOrderMesh second_order;      ///< the same with ten nodes each; empty unless options.order is 2
  std::vector<double> fraction;      ///< of the first constituent at each point, clamped to [0, 1]
  std::vector<double> variation;     ///< of each tetrahedron
  std::vector<double> dihedral_min;  ///< smallest dihedral angle of each tetrahedron, degrees
  std::vector<StageReport> stages;   ///< those that ran, in order

  /// "ok"; "threshold_not_met" where some tetrahedra stay above the threshold; else "deviation_not_met" where
  /// the finished boundary is farther from the true one than surface_deviation.
  std::string status = "ok";
  /// For a reader: why a criterion is not met and where, what was healed, ...
  std::vector<std::string> messages;
  /// Indices of the tetrahedra above the threshold.
  std::vector<std::int32_t> above_threshold;

  /// eta = N delta_0^3 / integral of |grad f|^3; 0 where the gradient vanishes everywhere.
  double element_ratio = 0.0;
  /// Largest distance of a facet's centre to the true boundary, mm; of the curved facet where order is 2.
  double deviation_max = 0.0;
  /// The surface deviation that was asked for, or its default for this part, mm.
  double surface_deviation = 0.0;
  double volume = 0.0;        ///< of the mesh, curved where order is 2, mm^3
  double shape_volume = 0.0;  ///< of the B-Rep, mm^3
  int threads = 1;
  double peak_memory_mb = 0.0;
};

/// Meshes the solids of a B-Rep graded by `material`: initial mesh, material-oriented refinement,
/// geometry-oriented refinement (paper, figure 2); then nodes in the middle of edges where order is 2.
///
/// `shape` is the text of a BREP or STEP file. Throws InvalidInput for what cannot be read, for options out
/// of range and for a material outside [0, 1]; GeometryError for a shape that is no valid solid; Cancelled.
MeshingResult generate_mesh(const std::string& shape, const ScalarField& material,
                            const MeshingOptions& options, RunControl& control);

}  // namespace fgmesh
