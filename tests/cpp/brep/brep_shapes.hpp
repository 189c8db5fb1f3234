// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <utility>
#include <vector>

#include "brep/brep_model.hpp"

namespace fgmesh::test {

/// A solid made in code, with what is known of it in closed form.
struct KnownSolid {
  std::string name;
  TopoDS_Shape shape;
  double volume;
  int euler;  ///< points - edges + triangles of its closed boundary: 2 - 2 * number of through holes
};

TopoDS_Shape box(double x, double y, double z);
TopoDS_Shape box_with_hole();  ///< 60 x 40 x 30 about the origin, hole of radius 8 along z at x = 15
TopoDS_Shape filleted_box();   ///< 40 x 30 x 20, one edge rounded with radius 5
TopoDS_Shape spline_prism();   ///< a closed B-spline profile without edges but its seam, extruded
/// A closed Bezier profile of one edge, with its tip of 2 atan(1/3) at the origin, extruded: one face whose
/// seam is sharp. Its area is 0.15 |P1 x P2| = 90.
TopoDS_Shape teardrop();
TopoDS_Shape thin_tube(double outer_radius, double inner_radius, double height);
TopoDS_Shape two_joined_boxes();  ///< two solids, cubes of 10 along x, that share one face

std::vector<KnownSolid> known_solids();

std::string brep_text(const TopoDS_Shape& shape);
/// Each of `roots` becomes a root of the file.
std::string step_text(const std::vector<TopoDS_Shape>& roots);
inline std::string step_text(const TopoDS_Shape& shape) {
  return step_text(std::vector<TopoDS_Shape>{shape});
}

BrepModel read(const TopoDS_Shape& shape);
std::pair<BrepModel, SampledBoundary> sampled(const TopoDS_Shape& shape, const SamplingOptions& options = {});

}  // namespace fgmesh::test
