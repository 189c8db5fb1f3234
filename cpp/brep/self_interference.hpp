// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "brep/topology.hpp"
#include "core/run_control.hpp"
#include "core/tet_mesh.hpp"

namespace fgmesh::brep {

/// Pairs of faces, edges or vertices of the solids that OpenCASCADE finds to cross or touch each other,
/// though they share no edge or vertex there; in the order of their numbers, faces first. Slow: it intersects
/// each face with all that are near.
std::vector<std::array<Carrier, 2>> self_interferences(const Topology& topology, RunControl& control);

}  // namespace fgmesh::brep
