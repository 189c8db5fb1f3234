// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/certificate_report.hpp"
#include "core/composition_field.hpp"
#include "core/run_control.hpp"
#include "core/second_order_mesh.hpp"
#include "core/stage_report.hpp"
#include "core/tet_mesh.hpp"
#include "pipeline/meshing_options.hpp"

namespace fgmesh {

struct MeshingResult {
  TetMesh mesh;                  ///< four-node tetrahedra
  SecondOrderMesh second_order;  ///< the same with ten nodes each; empty unless options.order is 2
  /// Where faces of the shape coincide, their triangles carry the lowest FaceN. Each row here is such a
  /// triangle and a further FaceN that it lies on.
  std::vector<std::array<std::int32_t, 2>> coincident_faces;
  /// Of the material that has most; columns of the fractions.
  int constituents = 2;
  /// Volume fraction of each constituent at each point, row by row, clamped to [0, 1]; on an interface that
  /// of the lowest solid; zeros at the end of the row where its material has fewer constituents.
  std::vector<double> fractions;
  /// The same at the nodes of each tetrahedron, in its own material. Empty where all solids have one
  /// material.
  std::vector<double> tet_fractions;
  std::vector<double> variation;     ///< of each tetrahedron
  std::vector<double> dihedral_min;  ///< smallest dihedral angle of each tetrahedron, degrees
  std::vector<StageReport> stages;   ///< those that ran, in order

  /// "ok"; "threshold_not_met" where some tetrahedra stay above the threshold, at their corners or, as the
  /// certificate tells, between them; else "deviation_not_met" where
  /// the finished boundary is farther from the true one than surface_deviation.
  std::string status = "ok";
  /// For a reader: why a criterion is not met and where, what was healed, ...
  std::vector<std::string> messages;
  /// Indices of the tetrahedra above the threshold.
  std::vector<std::int32_t> above_threshold;
  /// Indices of the tetrahedra with a dihedral angle below angle_goal: those where the shape forces it, and
  /// the others.
  std::vector<std::int32_t> forced_angles, small_angles;
  double angle_goal = 0.0;  ///< degrees
  /// What is proved of the threshold between the corners; where options.order is 2, of the straight
  /// tetrahedra. The indices of those that break it anywhere, and of those for which nothing was proved.
  CertificateReport certificate;
  std::vector<std::int32_t> broken, unproved;

  /// eta = N delta_0^3 / integral of |grad f|^3, the gradient of the composition; 0 where the gradient
  /// vanishes everywhere.
  double element_ratio = 0.0;
  /// Largest distance of a facet's centre to the true boundary, mm; of the curved facet where order is 2.
  double deviation_max = 0.0;
  /// The surface deviation that was asked for, or its default for this part, mm.
  double surface_deviation = 0.0;
  double volume = 0.0;                      ///< of the mesh, curved where order is 2, mm^3
  double shape_volume = 0.0;                ///< of the B-Rep, mm^3; what several solids hold counts once
  std::vector<double> solid_volumes;        ///< of the mesh in each SolidN, mm^3
  std::vector<double> shape_solid_volumes;  ///< of each SolidN without what belongs to another, mm^3
  int threads = 1;                          ///< that it had
  double peak_memory_mb = 0.0;
};

/// Meshes the solids of a B-Rep graded by `material`: initial mesh, material-oriented refinement,
/// geometry-oriented refinement (paper, figure 2); the certificate of the threshold at the end of the last of
/// them; then nodes in the middle of edges where order is 2.
///
/// `materials` holds one for all solids, or that of SolidN at n - 1. Solids that touch, overlap or are nested
/// share their interfaces in the mesh; a region in several solids belongs to the lowest, but a solid that
/// would be left with nothing takes its own. A material may jump at an interface: each tetrahedron is
/// measured in its own solid's.
///
/// `shape` is the text of a BREP or STEP file. Throws InvalidInput for what cannot be read, for options out
/// of range, for another number of materials and for one outside [0, 1]; GeometryError for a shape that is no
/// valid solid; Cancelled.
MeshingResult generate_mesh(const std::string& shape, const std::vector<const CompositionField*>& materials,
                            const MeshingOptions& options, RunControl& control);
inline MeshingResult generate_mesh(const std::string& shape, const CompositionField& material,
                                   const MeshingOptions& options, RunControl& control) {
  return generate_mesh(shape, std::vector<const CompositionField*>{&material}, options, control);
}

}  // namespace fgmesh
