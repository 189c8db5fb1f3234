// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/tet_score.hpp"

namespace fgmesh {

/// Removes a vertex by drawing it along an edge onto its neighbour `target`, if every tetrahedron made scores
/// more than `least`. A vertex of a face goes along that face, one of an edge of the shape along that edge,
/// where that keeps the boundary as close to the true one as allowed_chord_error() asks, or as it is. The
/// mesh stays a complex by the link condition (Dey et al. 1999). Returns whether it did.
bool collapse_edge(MeshState& state, int vertex, int target, const TetScore& score, double least,
                   TetComplex::Site& site);
inline bool collapse_edge(MeshState& state, int vertex, int target, const TetScore& score, double least) {
  return collapse_edge(state, vertex, target, score, least, state.complex.own_site());
}

}  // namespace fgmesh
