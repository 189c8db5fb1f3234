// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brep/brep_model.hpp"
#include "pipeline/generate_mesh.hpp"

namespace fgmesh {

/// "Edge7", as in the shape that was given, of a part of its separated solids; "an edge where solids were
/// separated" of one that it has not.
std::string given_name(const Carrier& part, const Origins& origins);

/// Puts the numbers of the shape that was given in place of those of its separated solids.
void use_given_numbers(MeshingResult& result, const Origins& origins);

}  // namespace fgmesh
