// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "brep/topology.hpp"
#include "core/run_control.hpp"
#include "core/vec3.hpp"

namespace fgmesh::brep {

/// A shape that is known to be one or more valid, closed solids.
struct CheckedShape {
  Topology topology;
  std::vector<double> volumes;     ///< of each solid, from its true surfaces, mm^3
  Box bounds;                      ///< tight around the true surfaces
  double tolerance = 0.0;          ///< largest tolerance of an edge or vertex, mm
  std::vector<std::string> notes;  ///< what was put right or left out, for a reader

  double volume() const;
};

/// Throws GeometryError that names the offending sub-shape and a cure where `shape` has no solid, reaches to
/// infinity, has an open shell, no volume or a sub-shape that OpenCASCADE's BRepCheck finds invalid.
CheckedShape check_shape(const TopoDS_Shape& shape, RunControl& control);

}  // namespace fgmesh::brep
