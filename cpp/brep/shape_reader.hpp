// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>

#include "core/run_control.hpp"

namespace fgmesh::brep {

/// The shape in the text of a BREP or a STEP file, told apart by content; lengths of STEP are turned into mm,
/// and several roots of a STEP file become one compound. Nothing is checked but that there is a shape. Throws
/// InvalidInput for data that is neither, is empty or cut short; GeometryError where OpenCASCADE cannot build
/// the shape; Cancelled.
TopoDS_Shape read_shape(const std::string& text, RunControl& control);

}  // namespace fgmesh::brep
