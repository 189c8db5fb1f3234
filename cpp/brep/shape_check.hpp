// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "brep/brep_model.hpp"
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

  /// Where solids had to be separated from each other; empty where all parts are those of the shape given.
  Origins origins;

  double volume() const;
};

/// Throws GeometryError that names the offending sub-shape and a cure where `shape` has no solid, reaches to
/// infinity, has an open shell, no volume or a sub-shape that OpenCASCADE's BRepCheck finds invalid. How its
/// solids lie to each other does not matter.
CheckedShape check_solids(const TopoDS_Shape& shape, RunControl& control);

/// As check_solids(), with solids that touch, overlap or are nested made to meet in shared faces; see
/// fragment().
CheckedShape check_shape(const TopoDS_Shape& shape, RunControl& control);

/// Volume inside the faces of a solid, mm^3; negative where they point inwards.
double enclosed_volume(const TopoDS_Shape& solid);

}  // namespace fgmesh::brep
