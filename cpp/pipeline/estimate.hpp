// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/composition_field.hpp"
#include "core/run_control.hpp"
#include "pipeline/meshing_options.hpp"
#include "pipeline/meshing_start.hpp"

namespace fgmesh {

struct MeshEstimate {
  double tets = 0.0;       ///< expected of the finished mesh
  double memory_mb = 0.0;  ///< largest resident memory expected of a process that does nothing but mesh
};

/// How many tetrahedra are expected of the mesh of start.options, of which `asked` are those as they were
/// given, in place of the initial mesh of elements of `size`, mm, that start.state holds.
double expected_tets(const MeshingStart& start, const MeshingOptions& asked, double size,
                     RunControl& control);

/// What generate_mesh() is to give for these arguments, without doing it: the shape is read and its initial
/// mesh made, then the density that material and surface deviation want is summed up over that mesh.
/// Throws what generate_mesh() throws up to there.
MeshEstimate estimate_mesh(const std::string& shape, const std::vector<const CompositionField*>& materials,
                           const MeshingOptions& options, RunControl& control);

}  // namespace fgmesh
