// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>
#include <vector>

#include "core/run_control.hpp"

namespace fgmesh::brep {

struct HealedShape {
  TopoDS_Shape shape;
  std::vector<std::string> notes;  ///< what was wrong and was mended, for a reader
};

/// What OpenCASCADE's ShapeFix makes of an invalid shape: faces turned, edges made to run alike in space and
/// on their faces, and such. Nothing where it finds nothing to do, and where the healed shape has other
/// numbers of faces, edges, vertices or solids, or lies elsewhere by more than the tolerances that `shape`
/// came with. Not all that was wrong need be mended.
std::optional<HealedShape> heal(const TopoDS_Shape& shape, RunControl& control);

}  // namespace fgmesh::brep
