// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"
#include "quality/tet_certificate.hpp"

namespace fgmesh {

/// Proves the material threshold over the whole of each tetrahedron, where the stages look at its corners and
/// what these foretell. Those that break it are mended towards `goal`, or split, a few times over; not where
/// f jumps or edges would become shorter than MeshState::min_size. The certificate of each slot of the
/// complex; that of a free one says nothing.
std::vector<TetCertificate> certify_mesh(MeshState& state, const QualityGoal& goal, RunControl& control);

}  // namespace fgmesh
