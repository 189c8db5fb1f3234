// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/vec3.hpp"

namespace fgmesh {

/// The faces of a tetrahedron: face i is opposite vertex i, its vertices counter-clockwise seen from outside.
inline constexpr int kFaceVertices[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// Its edges. Edge e lies between the two faces that are opposite the vertices of edge 5 - e.
inline constexpr int kEdgeVertices[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// Six times the signed volume; positive for the orientation of VTK.
inline double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

inline double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return orientation(a, b, c, d) / 6.0;
}

/// Twice the area of a triangle times its unit normal.
inline Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

inline double longest_edge_squared(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (d - a).squaredNorm(), (c - b).squaredNorm(),
                   (d - b).squaredNorm(), (d - c).squaredNorm()});
}

/// Sum of the squared edge lengths.
inline double squared_edges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (a - b).squaredNorm() + (a - c).squaredNorm() + (a - d).squaredNorm() + (b - c).squaredNorm() +
         (b - d).squaredNorm() + (c - d).squaredNorm();
}

/// Cosines of the six dihedral angles, in the order of kEdgeVertices. A face without area gives a
/// cosine of 1 (an angle of 0) at its edges, so that flat tetrahedra rank worst.
std::array<double, 6> dihedral_cosines(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

inline constexpr double kDegrees = 180.0 / 3.14159265358979323846;  ///< in a radian

/// The angle that has a cosine, degrees; what rounding puts beyond [-1, 1] counts as its end.
inline double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegrees; }

/// Smallest and largest of the six dihedral angles, degrees.
struct AngleRange {
  double smallest = 0.0;
  double largest = 180.0;
};
AngleRange dihedral_range(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace fgmesh
