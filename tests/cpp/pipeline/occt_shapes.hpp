// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace fgmesh::test {

// BREP text of solids; lengths in mm.
std::string box_text(double x, double y, double z);       ///< from the origin
std::string ball_text(double radius);                     ///< about the origin
std::string cylinder_text(double radius, double height);  ///< about the z axis, from z = 0

}  // namespace fgmesh::test
