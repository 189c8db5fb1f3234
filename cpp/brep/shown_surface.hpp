// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/run_control.hpp"
#include "core/vec3.hpp"

namespace fgmesh {

/// A face as triangles, with points of its own, outward from its solid.
struct FaceTriangles {
  int solid = 0;  ///< number of the solid, from 0
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Every face of every solid in the text of a BREP or STEP file, to be looked at: neighbours have equal
/// points along their edge, and a face that OpenCASCADE cannot triangulate has none. `deflection` in mm,
/// `angle` between chords in radians. Throws what reading a shape throws.
std::vector<FaceTriangles> shown_triangles(const std::string& shape, double deflection, double angle,
                                           RunControl& control);

/// Points of the boundary, true to rounding, that tell how far a shape reaches in any direction and from any
/// axis or point: vertices, points of curved edges, and points inside those faces that are no planes and have
/// no straight lines in them (what is largest on a straight line is so at an end). Nothing is triangulated.
/// Throws what reading a shape throws.
std::vector<Vec3> reach_points(const std::string& shape, RunControl& control);

}  // namespace fgmesh
