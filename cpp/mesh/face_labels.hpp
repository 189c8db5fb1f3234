// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Finds which face of the shape each boundary facet belongs to, writes it into `facets`, and brings every
/// boundary vertex onto its true vertex, edge or face. `creases` are mesh edges with the curve of `samples`
/// that they follow.
///
/// Facets are gathered into patches bounded by crease edges: whole patches are labelled, so that a label
/// never ends anywhere but at a crease. Throws GeometryError where a face of the shape gets no facet.
void carry_boundary_vertices(MeshState& state, const SampledBoundary& samples,
                             const std::vector<std::array<int, 3>>& creases,
                             std::vector<LabelledFacet>& facets);

}  // namespace fgmesh
