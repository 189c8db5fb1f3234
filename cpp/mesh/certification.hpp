// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"
#include "quality/tet_certificate.hpp"

namespace fgmesh {

struct CertificationOptions {
  double min_size = 0.0;  ///< mm; no edge is split into shorter ones
  QualityGoal goal;
  int most_tets = 20000000;  ///< nothing is mended once the mesh has as many
};

/// Proves the material threshold over the whole of each tetrahedron, where the stages look at its corners,
/// and splits those that break it in between, a few times over; not where f jumps or edges would become
/// shorter than min_size. The certificate of each slot of the complex; that of a free one says nothing.
std::vector<TetCertificate> certify_mesh(MeshState& state, const CertificationOptions& options,
                                         RunControl& control);

}  // namespace fgmesh
