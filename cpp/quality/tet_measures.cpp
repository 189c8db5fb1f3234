// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/tet_measures.hpp"

namespace fgmesh {
std::array<double, 6> dihedral_cosines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ab = b - a, ac = c - a, ad = d - a;
  // Outward area vectors of the faces; they sum to zero.
  const std::array<Vec3, 4> face = {(c - b).cross(d - b), ad.cross(ac), ab.cross(ad), ac.cross(ab)};
  std::array<double, 4> length;
  for (int i = 0; i < 4; ++i) length[i] = face[i].norm();
  std::array<double, 6> cosines;
  for (int edge = 0; edge < 6; ++edge) {
    const int i = kEdgeVertices[5 - edge][0], j = kEdgeVertices[5 - edge][1];
    const double product = length[i] * length[j];
    cosines[edge] = product > 0.0 ? -face[i].dot(face[j]) / product : 1.0;
  }
  return cosines;
}

AngleRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const std::array<double, 6> cosines = dihedral_cosines(a, b, c, d);
  const auto [low, high] = std::minmax_element(cosines.begin(), cosines.end());
  return {angle_of(*high), angle_of(*low)};
}

}  // namespace fgmesh
