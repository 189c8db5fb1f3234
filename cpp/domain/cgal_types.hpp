// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The only file that names CGAL's kernel, domain and triangulation: they are instantiated once.

// Where a step of Mesh_3 fails, CGAL would write debugging files into the user's folder before it throws.
// Its header of those writers is replaced (the guard is that of CGAL 5 or of CGAL 6).
#define CGAL_MESH_3_DUMP_C3T3_H
#define CGAL_SMDS_3_DUMP_C3T3_H
#include <string>
namespace CGAL {
template <class C3t3>
void dump_c3t3(const C3t3&, std::string) {}
template <class C3t3>
void dump_c3t3_edges(const C3t3&, std::string) {}
}  // namespace CGAL

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Polyhedron_3.h>

#include "core/vec3.hpp"

namespace fgmesh {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPolyhedron = CGAL::Polyhedron_3<CgalKernel>;
using CgalDomain =
    CGAL::Mesh_domain_with_polyline_features_3<CGAL::Polyhedral_mesh_domain_3<CgalPolyhedron, CgalKernel>>;
using CgalTriangulation = CGAL::Mesh_triangulation_3<CgalDomain>::type;
using CgalComplex = CGAL::Mesh_complex_3_in_triangulation_3<CgalTriangulation, CgalDomain::Corner_index,
                                                            CgalDomain::Curve_index>;

inline CgalKernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

template <class Point>
Vec3 to_vec3(const Point& p) {
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

}  // namespace fgmesh
