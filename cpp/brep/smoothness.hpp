// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <gp_Pnt2d.hxx>

#include "brep/topology.hpp"

namespace fgmesh::brep {

/// True for an edge that mesh edges must follow: any that bounds solids but degenerate ones and seams, and
/// those seams too across which the face is not smooth (a closed profile with a kink, extruded).
bool is_crease(const Topology& topology, int edge);

/// Whether a surface has the same normal at two places, but for what imported faces that are meant to join
/// smoothly differ by. Not where it has none.
bool normals_agree(const Geom_Surface& surface, const gp_Pnt2d& a, const gp_Pnt2d& b);

/// The same of the directions of a curve.
bool tangents_agree(const Geom_Curve& curve, double first, double last);

}  // namespace fgmesh::brep
