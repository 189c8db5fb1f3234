// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fgmesh {

/// Counts over equal bins of [low, high]; values at `high` fall into the last bin.
struct Histogram {
  double low = 0.0;
  double high = 0.0;
  std::vector<std::size_t> counts;
};

/// One row of the paper's table 1, and the histograms that its figures 7, 8 and 10 draw.
struct StageReport {
  std::string name;  ///< "initial", "material" or "geometry"
  std::size_t points = 0;
  std::size_t facets = 0;  ///< boundary and interface triangles
  std::size_t tets = 0;

  double variation_min = 0.0, variation_max = 0.0, variation_mean = 0.0;
  std::size_t above_threshold = 0;
  Histogram variation_histogram;  ///< one value a tetrahedron

  double dihedral_min = 0.0, dihedral_max = 0.0;  ///< degrees
  Histogram dihedral_histogram;                   ///< six values a tetrahedron

  double seconds = 0.0;
};

}  // namespace fgmesh
