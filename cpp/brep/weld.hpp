// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "brep/sampling.hpp"

namespace fgmesh::brep {

/// Where the triangulation of a sub-shape is found: the sub-shape itself, or its counterpart in a copy.
using TriangulatedCopy = std::function<TopoDS_Shape(const TopoDS_Shape&)>;

/// Joins the triangulations that BRepMesh left on the faces into one, with one point for each sample of an
/// edge and for each vertex, whatever the number of faces that meet there. Nothing and a `fault` in words,
/// with the number of the face, where the triangulations do not fit.
std::optional<Sampling> weld(const CheckedShape& shape, const TriangulatedCopy& triangulated,
                             std::string& fault);

}  // namespace fgmesh::brep
