// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/reference.hpp"
#include "core/run_control.hpp"

namespace fgmesh {

/// References to the parts `names` ("Face3", "Edge1", "Vertex2", "Solid1", as FreeCAD numbers them) of the
/// shape in the text of a BREP or STEP file: distances in mm, exact on the true faces and edges. Throws
/// InvalidInput that names the part which the shape does not have, and for text that is no shape;
/// GeometryError for a shape that is no valid solid; Cancelled.
std::vector<Reference> make_references(const std::string& shape, const std::vector<std::string>& names,
                                       RunControl& control);

}  // namespace fgmesh
