// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

/// Splits the edge (a, b), which tetrahedron t has, by a new vertex half-way, on the edge's carrier.
/// Where the new vertex lies beyond a face of the tetrahedra around the edge (a hollow wall), those behind
/// that face make room too, inner vertices among them may go. Returns the vertex; -1, and nothing is changed,
/// where the boundary or MeshState::min_size is in the way.
int split_edge(MeshState& state, int a, int b, int t);

/// Puts a vertex at a place inside the solid near the inner edge (a, b) instead of that edge, and of whatever
/// else hides it from there, where that raises the worst score of those tetrahedra by at least `gain`.
/// Returns whether it did.
bool insert_beside_edge(MeshState& state, int a, int b, const Vec3& place, const TetScore& score,
                        double gain);

/// Splits a boundary edge, or, as long as a facet at it has a longer one, that edge instead: bisection of the
/// longest edge keeps facets from degenerating (Rivara 1984). Returns as split_edge().
int split_boundary_edge(MeshState& state, int a, int b, int t);

/// How many times longer an edge (a, b) of this length, mm, is than it may be.
using Excess = std::function<double(int a, int b, double length)>;

/// Splits in each tetrahedron the edge of the largest excess, where that is above 1; none that would become
/// shorter than MeshState::min_size, and none of a tetrahedron that another split of this call has touched.
/// Returns how many.
int split_long_edges(MeshState& state, const Excess& excess, RunControl& control);
/// The same of edges longer than `longest`, mm.
int split_long_edges(MeshState& state, double longest, RunControl& control);

/// Splits boundary edges that are farther from the true boundary than allowed_chord_error(), until they are
/// not, would become shorter than MeshState::min_size, or cannot be split. Returns how many were.
int resolve_boundary(MeshState& state, RunControl& control);

}  // namespace fgmesh
