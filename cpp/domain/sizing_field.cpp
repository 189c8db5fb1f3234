// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/sizing_field.hpp"

#include <algorithm>

namespace fgmesh {

double SizingField::at(const Vec3& gradient) const {
  const double slope = gradient.norm();
  if (!(slope * max_size > constant)) return max_size;
  return std::max(min_size, constant / slope);
}

}  // namespace fgmesh
