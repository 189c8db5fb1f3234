// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brep/topology.hpp"

namespace fgmesh::brep {

/// What OpenCASCADE's BRepCheck finds wrong with the parts of `shape`, in words, from the smallest part to
/// the largest: a bad edge makes all that holds it bad.
std::vector<std::string> faults_of(const TopoDS_Shape& shape, const Topology& topology);

/// Throws GeometryError that names up to three sub-shapes which OpenCASCADE's BRepCheck finds invalid, and
/// says in words what is wrong with each.
void require_valid(const TopoDS_Shape& solid, const Topology& topology);

}  // namespace fgmesh::brep
