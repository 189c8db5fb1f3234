// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <optional>
#include <string>
#include <vector>

#include "brep/brep_model.hpp"
#include "brep/topology.hpp"
#include "core/run_control.hpp"

namespace fgmesh::brep {

/// Solids that meet in shared faces only, made from solids that touched, overlapped or were nested.
struct Fragments {
  TopoDS_Shape shape;
  Origins origins;
  std::vector<std::string> notes;  ///< what was done, for a reader
};

/// Makes the solids of a shape, with these volumes (mm^3), meet in shared faces: OpenCASCADE's General Fuse.
/// Nothing where they do already. A region in several solids goes to the lowest; but a solid that would be
/// left with nothing takes its region from those around it (a ball in a box). Throws GeometryError that names
/// the solids where OpenCASCADE cannot separate them; Cancelled.
std::optional<Fragments> fragment(const Topology& topology, const std::vector<double>& volumes,
                                  RunControl& control);

}  // namespace fgmesh::brep
