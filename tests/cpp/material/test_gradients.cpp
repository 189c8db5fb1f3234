// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "material/formula_operation.hpp"
#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_near(const Vec3& got, const Vec3& expected, double tolerance, const std::string& what) {
  for (int i = 0; i < 3; ++i) {
    if (got[i] == expected[i]) continue;  // infinities too
    EXPECT_NEAR(got[i], expected[i], tolerance) << what << ", component " << i;
  }
}

/// Fourth-order central differences.
Vec3 numeric_gradient(const Material& material, const Vec3& p, double h) {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [&](double steps) {
      Vec3 moved = p;
      moved[axis] += steps * h;
      return value_at(material, moved);
    };
    result[axis] = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * h);
  }
  return result;
}

TEST(Gradients, MatchDifferencesOfEveryFunctionInEveryFrame) {
  std::mt19937 random(7);
  for (const std::string& formula : sample_formulas()) {
    for (const Frame& frame : {Frame{}, rotated_frame()}) {
      const Material material({formula}, {}, frame);
      int agreed = 0, tried = 0;
      for (int i = 0; i < 200; ++i) {
        const Vec3 p = random_point(random, 3.0);
        // Two step widths that disagree betray a jump, a kink or a pole nearby.
        const Vec3 coarse = numeric_gradient(material, p, 2e-4), fine = numeric_gradient(material, p, 1e-4);
        const double scale = 1.0 + fine.norm();
        if (!((coarse - fine).norm() < 1e-7 * scale)) continue;
        ++tried;
        agreed += (gradient_at(material, p) - fine).norm() < 1e-6 * scale;
      }
      EXPECT_EQ(agreed, tried) << formula;
      EXPECT_GT(tried, 80) << formula;
    }
  }
}

TEST(Gradients, SamplesUseEveryFunctionOfTheTable) {
  std::string all;
  for (const std::string& formula : sample_formulas()) all += formula + "\n";
  for (const Operation& function : formula_functions()) {
    EXPECT_NE(all.find(std::string(function.name) + "("), std::string::npos) << function.name;
  }
}

TEST(Gradients, HaveClosedForms) {
  std::mt19937 random(3);
  const double alpha = 0.08;
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = random_point(random, 20.0);
    const double d = p.norm(), r2 = p[0] * p[0] + p[1] * p[1];
    expect_near(gradient_of("exp(-alpha*d)", p, {{"alpha", alpha}}), -alpha * std::exp(-alpha * d) / d * p,
                1e-15, "exp(-alpha*d)");
    expect_near(gradient_of("d^0.5", p), 0.5 * std::pow(d, -1.5) * p, 1e-14, "d^0.5");
    expect_near(gradient_of("theta", p), Vec3(-p[1], p[0], 0.0) / r2, 1e-12 / std::sqrt(r2), "theta");
    expect_near(gradient_of("x*y*z", p), Vec3(p[1] * p[2], p[0] * p[2], p[0] * p[1]), 1e-12, "x*y*z");
    expect_near(gradient_of("x^3", p), Vec3(3.0 * p[0] * p[0], 0.0, 0.0), 1e-11, "x^3");
  }
}

TEST(Gradients, AreOfTheWorldInATurnedFrame) {
  const Frame frame = rotated_frame();
  const Material height({"z"}, {}, frame), radius({"r"}, {}, frame), distance({"d"}, {}, frame);
  const Vec3 axis = frame.rotation.col(2);
  std::mt19937 random(5);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = random_point(random, 20.0), offset = p - frame.origin;
    const Vec3 away = offset - axis.dot(offset) * axis;
    EXPECT_NEAR(value_at(height, p), axis.dot(offset), 1e-13);
    EXPECT_NEAR(value_at(radius, p), axis.cross(offset).norm(), 1e-13);
    EXPECT_NEAR(value_at(distance, p), offset.norm(), 1e-13);
    expect_near(gradient_at(height, p), axis, 1e-15, "z");
    expect_near(gradient_at(radius, p), away.normalized(), 1e-13, "r");
    expect_near(gradient_at(distance, p), offset.normalized(), 1e-13, "d");
  }
}

struct Singular {
  const char* formula;
  Vec3 point;
  double value;
  Vec3 gradient;
};

class SingularPoints : public testing::TestWithParam<Singular> {};

TEST_P(SingularPoints, HaveTheirGradient) {
  const Singular& s = GetParam();
  EXPECT_DOUBLE_EQ(value_of(s.formula, s.point), s.value) << s.formula;
  expect_near(gradient_of(s.formula, s.point), s.gradient, 1e-12, s.formula);
}

const Vec3 kOrigin = Vec3::Zero();

INSTANTIATE_TEST_SUITE_P(Undefined, SingularPoints,
                         testing::Values(Singular{"d", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"exp(-0.08*d)", kOrigin, 1.0, Vec3(0, 0, 0)},
                                         Singular{"d^0.5", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"sqrt(d) + x", kOrigin, 0.0, Vec3(1, 0, 0)},
                                         Singular{"r + z", Vec3(0, 0, 3), 3.0, Vec3(0, 0, 1)},
                                         Singular{"theta", Vec3(0, 0, 3), 0.0, Vec3(0, 0, 0)},
                                         Singular{"atan2(y, x)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"abs(x)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"max(x, -x)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"min(x, x)", Vec3(2, 0, 0), 2.0, Vec3(1, 0, 0)},
                                         Singular{"max(x, y)", Vec3(2, 2, 0), 2.0, Vec3(0.5, 0.5, 0)},
                                         Singular{"clamp(x, 0, 1)", kOrigin, 0.0, Vec3(1, 0, 0)},
                                         Singular{"sign(x) + floor(x) + ceil(x) + step(0, x)", kOrigin, 1.0,
                                                  Vec3(0, 0, 0)},
                                         Singular{"sqrt(x^2 + y^2 + z^2)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"exp(-1/d)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"theta", Vec3(-2, 0, 0), M_PI, Vec3(0, -0.5, 0)}));

INSTANTIATE_TEST_SUITE_P(Unbounded, SingularPoints,
                         testing::Values(Singular{"sqrt(x)", kOrigin, 0.0, Vec3(kInfinity, 0, 0)},
                                         Singular{"cbrt(y)", kOrigin, 0.0, Vec3(0, kInfinity, 0)},
                                         Singular{"x^0.5", kOrigin, 0.0, Vec3(kInfinity, 0, 0)},
                                         Singular{"1 - sqrt(x)", kOrigin, 1.0, Vec3(-kInfinity, 0, 0)},
                                         Singular{"asin(x)", Vec3(1, 0, 0), M_PI / 2, Vec3(kInfinity, 0, 0)},
                                         Singular{"0*sqrt(x)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"y*sqrt(x)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"sqrt(x) + sqrt(-x)", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"tanh(1e4*x)", Vec3(1, 0, 0), 1.0, Vec3(0, 0, 0)},
                                         Singular{"1/(1 + exp(1e4*x))", Vec3(1, 0, 0), 0.0, Vec3(0, 0, 0)}));

INSTANTIATE_TEST_SUITE_P(Powers, SingularPoints,
                         testing::Values(Singular{"x^2", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"x^1", kOrigin, 0.0, Vec3(1, 0, 0)},
                                         Singular{"x^3", kOrigin, 0.0, Vec3(0, 0, 0)},
                                         Singular{"x^0", kOrigin, 1.0, Vec3(0, 0, 0)},
                                         Singular{"x^3", Vec3(-2, 0, 0), -8.0, Vec3(12, 0, 0)},
                                         Singular{"x^-1", Vec3(-2, 0, 0), -0.5, Vec3(-0.25, 0, 0)},
                                         Singular{"(-2)^z", Vec3(0, 0, 3), -8.0, Vec3(0, 0, 0)},
                                         Singular{"x^y", Vec3(-2, 3, 0), -8.0, Vec3(12, 0, 0)},
                                         Singular{"x^y", Vec3(0, 2, 0), 0.0, Vec3(0, 0, 0)},
                                         Singular{"x^y", Vec3(2, 3, 0), 8.0, Vec3(12, 8 * M_LN2, 0)},
                                         Singular{"2^x", Vec3(3, 0, 0), 8.0, Vec3(8 * M_LN2, 0, 0)}));

INSTANTIATE_TEST_SUITE_P(Branches, SingularPoints,
                         testing::Values(Singular{"if(x > 0, log(x), 0)", Vec3(-1, 0, 0), 0.0, Vec3(0, 0, 0)},
                                         Singular{"if(x > 0, log(x), y)", Vec3(0, 0, 0), 0.0, Vec3(0, 1, 0)},
                                         Singular{"x > 0 ? log(x) : 0", Vec3(2, 0, 0), M_LN2,
                                                  Vec3(0.5, 0, 0)},
                                         Singular{"x < 0 ? sqrt(x) : x", Vec3(4, 0, 0), 4.0, Vec3(1, 0, 0)},
                                         Singular{"y == 0 ? x : x/y", Vec3(4, 0, 0), 4.0, Vec3(1, 0, 0)}));

TEST(Gradients, AreNaNExactlyWhereTheValueIs) {
  EXPECT_TRUE(std::isnan(gradient_of("log(x)", Vec3(-1, 0, 0))[1]));
  EXPECT_TRUE(std::isnan(gradient_of("sqrt(x)", Vec3(-1, 0, 0))[0]));
}

}  // namespace
}  // namespace fgmesh::test
