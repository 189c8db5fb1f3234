// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "core/run_control.hpp"

namespace fgmesh::brep {

struct ReadShape {
  TopoDS_Shape shape;
  std::vector<std::string> notes;  ///< what is wrong with the file without harm to the shape
};

/// The shape in the text of a BREP or a STEP file, told apart by content; lengths of STEP are turned into mm,
/// and several roots of a STEP file become one compound. Nothing is checked but that there is a shape. Throws
/// InvalidInput for data that is neither, is empty, cut short or damaged; GeometryError where OpenCASCADE
/// cannot build the shape, or all its solids; Cancelled.
ReadShape read_shape(const std::string& text, RunControl& control);

}  // namespace fgmesh::brep
