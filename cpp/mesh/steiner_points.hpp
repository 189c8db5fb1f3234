// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/run_control.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// Step (i) of the paper's section 2.3.3: a Steiner point into the tetrahedra that vary by more than `limit`,
/// worst first, half-way along the edge on which f varies most; none into a tetrahedron that another point of
/// this call has touched, at most `most`. Where a coarse boundary facet is near, its longest edge is split
/// instead. Left out are tetrahedra whose variation is a jump of f, or is on edges that would become shorter
/// than MeshState::min_size. Returns how many points were inserted.
int insert_steiner_points(MeshState& state, double limit, std::size_t most, RunControl& control);

/// True where the composition changes on the way from a to b by far more than its gradients there foretell: a
/// jump, or a steep layer, is between the two.
bool is_sudden(const MaterialValue& a, const MaterialValue& b, const Vec3& way, double threshold);

/// True where f jumps by more than `threshold` somewhere between p and q: no refinement brings the variation
/// below it there. Told by bisection.
bool jumps_between(const CompositionField& field, Vec3 p, Vec3 q, double threshold);

/// How many tetrahedra vary by more than `limit`.
int count_above(const MeshState& state, double limit);

/// The same without those that no point may be put into: a jump, or min_size, is in the way.
int count_divisible(const MeshState& state, double limit);

}  // namespace fgmesh
