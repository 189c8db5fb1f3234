// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <ostream>

namespace fgmesh {

/// A point or a direction in space; lengths are mm throughout.
using Vec3 = Eigen::Vector3d;

/// A point for a reader: "(1, 2.5, 0)".
struct Shown {
  const Vec3& point;
};
inline std::ostream& operator<<(std::ostream& out, const Shown& shown) {
  return out << '(' << shown.point.x() << ", " << shown.point.y() << ", " << shown.point.z() << ')';
}

/// An axis-aligned box.
struct Box {
  Vec3 low = Vec3::Constant(0.0);
  Vec3 high = Vec3::Constant(0.0);

  double diagonal() const { return (high - low).norm(); }
};

/// The corners of a tetrahedron.
using Corners = std::array<Vec3, 4>;

inline Box box_around(const Corners& tet) {
  return {tet[0].cwiseMin(tet[1]).cwiseMin(tet[2]).cwiseMin(tet[3]),
          tet[0].cwiseMax(tet[1]).cwiseMax(tet[2]).cwiseMax(tet[3])};
}

}  // namespace fgmesh
