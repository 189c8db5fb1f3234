// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brep/topology.hpp"

namespace fgmesh::brep {

/// Throws GeometryError that names up to three sub-shapes which OpenCASCADE's BRepCheck finds invalid, and
/// says in words what is wrong with each.
void require_valid(const TopoDS_Shape& solid, const Topology& topology);

}  // namespace fgmesh::brep
