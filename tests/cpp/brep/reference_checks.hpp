// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopoDS_Shape.hxx>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "brep/references.hpp"
#include "brep_shapes.hpp"

namespace fgmesh::test {

constexpr double kExact = 1e-9;  // parts of the diagonal, as promised

inline Reference reference(const TopoDS_Shape& shape, const std::string& name) {
  RunControl control;
  return make_references(test::brep_text(shape), {name}, control).front();
}

/// Points in a box about the origin, at random but the same in each run.
inline std::vector<Vec3> random_points(int count, double reach, const Vec3& centre = Vec3::Zero()) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    points.push_back(centre + Vec3(coordinate(generator), coordinate(generator), coordinate(generator)));
  }
  return points;
}

inline double value_at(const Reference& reference, const Vec3& p) {
  double value = 0.0;
  reference.distance->evaluate(&p, 1, &value);
  return value;
}

inline Vec3 gradient_at(const Reference& reference, const Vec3& p) {
  double value = 0.0;
  Vec3 gradient;
  reference.distance->evaluate(&p, 1, &value, &gradient);
  return gradient;
}

/// In a plane through the axis of a body of revolution: radius and height.
inline Eigen::Vector2d meridian(const Vec3& p) { return {std::hypot(p.x(), p.y()), p.z()}; }

}  // namespace fgmesh::test
