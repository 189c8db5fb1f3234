// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/second_order_mesh.hpp"

namespace fgmesh {

/// The nodes of a ten-node tetrahedron in the order of VTK.
using CurvedTet = std::array<Vec3, 10>;

CurvedTet curved_tet(const SecondOrderMesh& mesh, std::size_t tet);

/// The 20 Bernstein coefficients of the Jacobian determinant, a cubic polynomial over the tetrahedron. It
/// lies between the smallest and the largest of them everywhere; where the edges are straight, all are six
/// times the volume (Johnen, Remacle, Geuzaine: Geometrical validity of curvilinear finite elements, 2013).
std::array<double, 20> jacobian_coefficients(const CurvedTet& nodes);

/// True where it is proved that the Jacobian determinant is above `least` in the whole tetrahedron.
bool jacobian_is_above(const CurvedTet& nodes, double least);

/// Volume of each curved tetrahedron, mm^3; exact.
std::vector<double> tet_volumes(const SecondOrderMesh& mesh);

/// Sum of the curved tetrahedra's volumes, mm^3; exact.
double volume(const SecondOrderMesh& mesh);

/// The point of a six-node triangle whose three coordinates are equal.
Vec3 centre_of_triangle(const SecondOrderMesh& mesh, std::size_t triangle);

}  // namespace fgmesh
