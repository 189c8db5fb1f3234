// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

#include "material/material.hpp"

namespace fgmesh::test {

inline double value_at(const Material& material, const Vec3& p) {
  double value = 0.0;
  material.evaluate(&p, 1, &value);
  return value;
}

inline double value_of(const std::string& formula, const Vec3& p = Vec3(0.3, -0.7, 1.9),
                       const std::map<std::string, double>& parameters = {}) {
  return value_at(Material({formula}, parameters), p);
}

inline Vec3 gradient_at(const Material& material, const Vec3& p) {
  double value = 0.0;
  Vec3 gradient;
  material.evaluate(&p, 1, &value, &gradient);
  return gradient;
}

inline Vec3 gradient_of(const std::string& formula, const Vec3& p,
                        const std::map<std::string, double>& parameters = {}) {
  return gradient_at(Material({formula}, parameters), p);
}

inline Vec3 random_point(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  const double x = coordinate(random), y = coordinate(random);
  return Vec3(x, y, coordinate(random));
}

inline Frame rotated_frame() {
  Frame frame;
  frame.origin = Vec3(1.5, -2.0, 0.25);
  frame.rotation = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  return frame;
}

/// Formulas that between them use every function, smooth almost everywhere for coordinates within +-5.
inline const std::vector<std::string>& sample_formulas() {
  static const std::vector<std::string> formulas = {
      "exp(-0.3*d)",
      "log(6.5 + x)",
      "log10(1 + d^2)",
      "sqrt(x^2 + y^2 + z^2)",
      "cbrt(x - 7)",
      "cbrt(x)",
      "pow(1.5 + 0.1*x, y)",
      "pow(x, 3)",
      "x^-2 + y^4",
      "x^2 - 3*x*y/(z^2 + 1)",
      "abs(x*y)",
      "sign(x)*z",
      "min(x, y, z)",
      "max(x, y*z)",
      "sin(x*y)",
      "cos(x) + sin(2*theta)",
      "tan(0.2*x)",
      "asin(0.19*x)",
      "acos(0.19*y)",
      "atan(3*x - z)",
      "atan2(y, x - 1)",
      "sinh(0.5*x)",
      "cosh(0.5*x)",
      "tanh(x + y)",
      "floor(x) + y",
      "ceil(y)*x",
      "clamp(x, -1, y)",
      "mix(x, y, 0.25*z)",
      "mix(0.2, 0.9, 0.1*x)",
      "step(1, x)*y",
      "smoothstep(-2, 3, x)",
      "smoothstep(3, -2, y)",
      "smoothstep(x, x + 2, z)",
      "x > y ? x^2 : y^3",
      "if(x > 0, log(x), x)",
      "r*theta",
      "r/20 + d/30",
      "1/(1 + exp(-4*(r - 2)))",
      "-x^2",
      "theta",
      "d^0.5",
      "(r - 2)/3",
      "x*x - 2*x + 1",
      "exp(x)/(1 + exp(x))",
      "1/x",
      "(x <= 1) - (y != z)",
  };
  return formulas;
}

}  // namespace fgmesh::test
