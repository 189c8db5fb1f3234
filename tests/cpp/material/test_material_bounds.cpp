// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

Box random_box(std::mt19937& random, double reach) {
  const Vec3 a = random_point(random, reach);
  const double size = std::pow(10.0, std::uniform_real_distribution<double>(-6.0, 1.0)(random));
  Vec3 sides = size * (random_point(random, 1.0).cwiseAbs());
  // Flat, straight and single-point boxes are boxes as well.
  for (int axis = 0; axis < 3; ++axis) {
    if (std::uniform_int_distribution<int>(0, 7)(random) == 0) sides[axis] = 0.0;
  }
  return {a, a + sides};
}

Vec3 point_in(const Box& box, std::mt19937& random) {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    switch (std::uniform_int_distribution<int>(0, 3)(random)) {
      case 0:
        p[axis] = box.low[axis];
        break;
      case 1:
        p[axis] = box.high[axis];
        break;
      default:
        p[axis] = std::min(box.high[axis], std::uniform_real_distribution<double>(
                                               box.low[axis], std::nextafter(box.high[axis], 1e9))(random));
    }
  }
  return p;
}

TEST(MaterialBounds, HoldEveryValueInTheBox) {
  std::mt19937 random(17);
  for (const std::string& formula : sample_formulas()) {
    for (const Frame& frame : {Frame{}, rotated_frame()}) {
      const Material material({formula}, {}, frame);
      for (int i = 0; i < 300; ++i) {
        Box box = random_box(random, 5.0);
        // Some boxes hold the origin, the axis and the cut of the angle.
        if (i % 3 == 0) box = {box.low - box.high, box.high - box.low};
        double low = 0.0, high = 0.0;
        material.bounds(box, &low, &high);
        for (int k = 0; k < 20; ++k) {
          const Vec3 p = point_in(box, random);
          const double value = value_at(material, p);
          if (!std::isfinite(value)) continue;
          ASSERT_TRUE(low <= value && value <= high) << formula << " is " << value << " at " << p.transpose()
                                                     << ", outside [" << low << ", " << high << "]";
        }
      }
    }
  }
}

TEST(MaterialBounds, AreTightWhereEveryVariableStandsOnce) {
  const Material material({"exp(-alpha*d)"}, {{"alpha", 0.08}});
  double low = 0.0, high = 0.0;
  material.bounds({Vec3(1, 2, 3), Vec3(4, 5, 6)}, &low, &high);
  EXPECT_NEAR(low, std::exp(-0.08 * std::sqrt(77.0)), 1e-14);
  EXPECT_NEAR(high, std::exp(-0.08 * std::sqrt(14.0)), 1e-14);
  material.bounds({Vec3(-1, -1, -1), Vec3(3, 1, 1)}, &low, &high);
  EXPECT_NEAR(low, std::exp(-0.08 * std::sqrt(11.0)), 1e-14);
  EXPECT_NEAR(high, 1.0, 1e-14);
  Material({"(r - 20)/20"}).bounds({Vec3(30, 0, -5), Vec3(40, 30, 5)}, &low, &high);
  EXPECT_NEAR(low, 0.5, 1e-14);
  EXPECT_NEAR(high, 1.5, 1e-14);
  Material({"z"}).bounds({Vec3(0, 0, -1.5), Vec3(1, 1, 2.25)}, &low, &high);
  EXPECT_EQ(low, -1.5);
  EXPECT_EQ(high, 2.25);
  Material({"x*x"}).bounds({Vec3(-2, 0, 0), Vec3(1, 1, 1)}, &low, &high);
  EXPECT_EQ(low, 0.0);
  EXPECT_EQ(high, 4.0);
}

TEST(MaterialBounds, ShrinkWithTheBox) {
  for (const std::string formula :
       {"x^2 - 3*x*y/(z^2 + 1)", "1/(1 + exp(-4*(r - 2)))", "smoothstep(x, x + 2, z)"}) {
    const Material material({formula});
    const Vec3 p(1.1, 0.7, 1.3);
    double previous = 1e9;
    for (const double size : {1.0, 1e-2, 1e-4, 1e-6}) {
      double low = 0.0, high = 0.0;
      material.bounds({p, p + Vec3::Constant(size)}, &low, &high);
      EXPECT_LT(high - low, 10.0 * size) << formula;
      EXPECT_LT(high - low, previous) << formula;
      previous = high - low;
    }
  }
}

TEST(MaterialBounds, FollowTheBranchesThatCanBeTaken) {
  const Material material({"x > 0 ? 1 + log(x) : y"});
  double low = 0.0, high = 0.0;
  material.bounds({Vec3(-2, 3, 0), Vec3(-1, 4, 0)}, &low, &high);
  EXPECT_EQ(low, 3.0);
  EXPECT_EQ(high, 4.0);
  material.bounds({Vec3(1, 3, 0), Vec3(1, 4, 0)}, &low, &high);
  EXPECT_NEAR(low, 1.0, 1e-14);
  EXPECT_NEAR(high, 1.0, 1e-14);
}

TEST(MaterialBounds, AreNaNWhereNothingIsDefined) {
  double low = 0.0, high = 0.0;
  Material({"log(x)"}).bounds({Vec3(-2, 0, 0), Vec3(-1, 1, 1)}, &low, &high);
  EXPECT_TRUE(std::isnan(low) && std::isnan(high));
  Material({"0/0"}).bounds({Vec3(-2, 0, 0), Vec3(-1, 1, 1)}, &low, &high);
  EXPECT_FALSE(low <= high && std::isfinite(low));
}

}  // namespace
}  // namespace fgmesh::test
