// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brep/topology.hpp"

namespace fgmesh::brep {

/// True for an edge that mesh edges must follow: any that bounds solids but degenerate ones and seams, and
/// those seams too across which the face is not smooth (a closed profile with a kink, extruded).
bool is_crease(const Topology& topology, int edge);

}  // namespace fgmesh::brep
