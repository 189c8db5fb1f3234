// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/composition_field.hpp"
#include "pipeline/generate_mesh.hpp"

namespace fgmesh {

/// How many tetrahedra miss the threshold, where the worst is, and what may be done. `field` is the material
/// of the worst one's solid.
std::string describe_misses(const MeshingResult& result, const CompositionField& field,
                            const MeshingOptions& options);

/// How many tetrahedra keep the threshold at their corners but break it in between, or may do so, where, and
/// what may be done. Empty where there are none.
std::string describe_certificate(const MeshingResult& result, const MeshingOptions& options);

/// How many edges could not follow the true boundary, where, and what may be done.
std::string describe_straightened(const MeshingResult& result);

}  // namespace fgmesh
