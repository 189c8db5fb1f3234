// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

#include "brep/topology.hpp"

namespace fgmesh::brep {

/// Throws GeometryError where the shape holds no solid: says what it holds instead, and how that becomes one.
void require_solid(const TopoDS_Shape& shape, const Topology& topology);

/// Throws GeometryError that names an edge which bounds one face of a solid only, and the edge of another
/// face that is to be joined with it where one lies beside it.
void require_closed(const Topology& topology);

}  // namespace fgmesh::brep
