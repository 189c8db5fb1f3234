// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The only file that names CGAL's kernel.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "core/vec3.hpp"

namespace fgmesh {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

inline CgalKernel::Point_3 to_cgal(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace fgmesh
