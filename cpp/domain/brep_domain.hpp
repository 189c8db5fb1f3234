// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "domain/cgal_types.hpp"

namespace fgmesh {

/// The sampled boundary as a CGAL mesh domain whose curves and corners are protected.
struct BrepDomain {
  std::unique_ptr<CgalPolyhedron> surface;  ///< the domain searches in it
  std::unique_ptr<CgalDomain> domain;
  std::vector<int> curve_of_index;  ///< CGAL's curve index -> position in SampledBoundary::curves; -1: none
};

/// Throws GeometryError where the samples do not bound a volume.
BrepDomain make_brep_domain(const SampledBoundary& samples);

}  // namespace fgmesh
