// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/composition.hpp"

#include <Eigen/Eigenvalues>

namespace fgmesh {

double magnitude(const Composition& change) {
  if (change.size() == 1) return std::abs(change[0]);
  double squares = 0.0, last = 0.0;
  for (const double part : change) {
    squares += part * part;
    last -= part;
  }
  return std::sqrt(squares + last * last);
}

Composition change(const Composition& from, const Composition& to) {
  Composition result = to;
  for (std::size_t i = 0; i < from.size(); ++i) result[i] -= from[i];
  return result;
}

Composition change_along(const CompositionGradient& gradient, const Vec3& way) {
  Composition result;
  for (const Vec3& part : gradient) result.push_back(part.dot(way));
  return result;
}

Vec3 gradient_towards(const CompositionGradient& gradient, const Composition& from, const Composition& to) {
  if (gradient.size() == 1) return to[0] < from[0] ? Vec3(-gradient[0]) : gradient[0];
  const Composition way = change(from, to);
  double last = 0.0;
  for (const double part : way) last -= part;
  Vec3 result = Vec3::Zero();
  for (std::size_t i = 0; i < gradient.size(); ++i) result += (way[i] - last) * gradient[i];
  const double length = magnitude(way);
  return length > 0.0 ? Vec3(result / length) : result;
}

Vec3 steepest(const CompositionGradient& gradient) {
  if (gradient.size() == 1) return gradient[0];
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vec3 last = Vec3::Zero();
  for (const Vec3& part : gradient) {
    squares += part * part.transpose();
    last -= part;
  }
  squares += last * last.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2])) * solver.eigenvectors().col(2);
}

}  // namespace fgmesh
