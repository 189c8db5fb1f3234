// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>

namespace fgmesh::brep {

/// Divides the spans of B-spline surfaces that have few, which leaves the surfaces as they are: BRepMesh
/// looks at a few places of each span only and misses how a long one bends, such as that of a whole turn.
void divide_spans(const TopoDS_Shape& shape);

}  // namespace fgmesh::brep
