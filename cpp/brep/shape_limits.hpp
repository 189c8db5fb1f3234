// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brep/topology.hpp"
#include "core/vec3.hpp"

namespace fgmesh::brep {

/// Throws GeometryError that names a vertex without a proper place: no number, or farther away than what
/// OpenCASCADE holds for infinity.
void require_finite(const Topology& topology);

/// Throws GeometryError for a part so small, or so large or far from the origin, that OpenCASCADE, which
/// takes points nearer than 1e-7 mm for one, cannot tell its parts apart.
void require_size(const Box& bounds);

/// Throws GeometryError for a solid whose walls are far too thin for tetrahedra.
void require_thickness(int solid, double volume, double area, double diagonal);

/// Throws GeometryError that names an edge which lies far off its vertices or faces, within a huge tolerance.
void require_small_gaps(const Topology& topology, double diagonal);

/// Where an edge runs farthest off one of its faces, in words; empty where none is off by more than a
/// millionth of `diagonal`.
std::string largest_gap(const Topology& topology, double diagonal);

}  // namespace fgmesh::brep
