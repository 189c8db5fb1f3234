// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

struct Bounds {
  double low = 0.0, high = 0.0;
  Vec3 slope_low = Vec3::Zero(), slope_high = Vec3::Zero();

  Bounds(const Material& material, const Corners& tet) {
    material.tet_bounds(tet, &low, &high, &slope_low, &slope_high);
  }
};

Corners random_tet(std::mt19937& random, double reach) {
  const Vec3 centre = random_point(random, reach);
  const double size = std::pow(10.0, std::uniform_real_distribution<double>(-4.0, 0.5)(random));
  Corners tet;
  for (Vec3& corner : tet) corner = centre + size * random_point(random, 1.0);
  return tet;
}

Vec3 point_in(const Corners& tet, std::mt19937& random) {
  std::array<double, 4> share;
  double sum = 0.0;
  for (double& part : share) sum += part = std::exponential_distribution<double>()(random);
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < 4; ++i) p += share[i] / sum * tet[i];
  return p;
}

Corners box_tet(const Vec3& low, double size) {
  return {low, low + size * Vec3::UnitX(), low + size * Vec3::UnitY(), low + size * Vec3::UnitZ()};
}

/// What the slopes allow the function to change on a way, at most or at least.
double change(const Vec3& low, const Vec3& high, const Vec3& way) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    if (way[axis] != 0.0) sum += (way[axis] > 0.0 ? high[axis] : low[axis]) * way[axis];
  return sum;
}

void expect_bounds_hold(const std::string& formula, const Frame& frame, std::mt19937& random) {
  const Material material({formula}, {}, frame);
  for (int i = 0; i < 200; ++i) {
    const Corners tet = random_tet(random, i % 3 == 0 ? 0.5 : 5.0);
    const Bounds bounds(material, tet);
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = point_in(tet, random), q = point_in(tet, random);
      const double at_p = value_at(material, p), at_q = value_at(material, q);
      if (!std::isfinite(at_p) || !std::isfinite(at_q)) continue;
      ASSERT_TRUE(bounds.low <= at_p && at_p <= bounds.high) << formula << " at " << p.transpose();
      const double most = change(bounds.slope_low, bounds.slope_high, p - q);
      const double least = change(bounds.slope_high, bounds.slope_low, p - q);
      const double rounding = 1e-11 * (1.0 + std::abs(at_p) + std::abs(at_q));
      if (std::isnan(most) || std::isnan(least)) continue;  // infinite both ways
      ASSERT_TRUE(least - rounding <= at_p - at_q && at_p - at_q <= most + rounding)
          << formula << " changes by " << at_p - at_q << " from " << q.transpose() << " to " << p.transpose()
          << ", not from " << least << " to " << most;
    }
  }
}

TEST(SlopeBounds, HoldEveryChangeInATetrahedron) {
  std::mt19937 random(29);
  for (const std::string& formula : sample_formulas())
    for (const Frame& frame : {Frame{}, rotated_frame()}) expect_bounds_hold(formula, frame, random);
}

TEST(SlopeBounds, HoldWhatTheFormulasOfTheSamplesDoNotReach) {
  std::mt19937 random(31);
  for (const char* formula : {"1/x",
                              "x^-1",
                              "x^-3",
                              "1/(x*y)",
                              "tan(x)",
                              "tan(2*x) + y",
                              "sqrt(x*y)",
                              "log(x*x - 1)",
                              "(x^2-1)^1.5",
                              "x^0.5",
                              "abs(x)^x",
                              "theta",
                              "cos(theta/2)",
                              "r",
                              "d",
                              "step(x, y)",
                              "if(x < y, x, 2*y)",
                              "x > 0 ? exp(x) : 1 + x",
                              "smoothstep(-1, 2, x*y)",
                              "smoothstep(y, 3, x)",
                              "atan(1/x)",
                              "min(1/x, 3)",
                              "x == y",
                              "floor(x*y)/3",
                              "sin(20*x)",
                              "asin(x*y)",
                              "max(x, y)*min(y, z)"})
    expect_bounds_hold(formula, {}, random);
}

TEST(SlopeBounds, HoldTables) {
  std::mt19937 random(37);
  std::vector<double> values(5 * 4 * 6);
  for (double& value : values) value = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  const SampledTable table({{Variable::kX, {-3, -1, 0, 2, 4}},
                            {Variable::kRadius, {0, 1, 2.5, 4}},
                            {Variable::kAngle, {-3, -1, 0, 0.5, 2, 3}}},
                           values);
  const Material material({"t1"}, {}, {}, {}, {std::make_shared<const SampledTable>(table)});
  for (int i = 0; i < 500; ++i) {
    const Corners tet = random_tet(random, 4.0);
    const Bounds bounds(material, tet);
    for (int k = 0; k < 12; ++k) {
      const Vec3 p = point_in(tet, random), q = point_in(tet, random);
      const double rise = value_at(material, p) - value_at(material, q);
      const double most = change(bounds.slope_low, bounds.slope_high, p - q);
      const double least = change(bounds.slope_high, bounds.slope_low, p - q);
      if (std::isnan(most) || std::isnan(least)) continue;
      ASSERT_TRUE(least - 1e-11 <= rise && rise <= most + 1e-11);
    }
  }
}

TEST(SlopeBounds, AreThoseOfClosedForms) {
  const Bounds squared(Material({"x^2 + 3*y"}), box_tet(Vec3(1, 0, 0), 0.5));
  EXPECT_NEAR(squared.slope_low.x(), 2.0, 1e-12);
  EXPECT_NEAR(squared.slope_high.x(), 3.0, 1e-12);
  EXPECT_EQ(squared.slope_low.y(), 3.0);
  EXPECT_EQ(squared.slope_high.y(), 3.0);
  EXPECT_EQ(squared.slope_low.z(), 0.0);
  const Bounds wave(Material({"sin(20*x)"}), box_tet(Vec3(0, 0, 0), 0.05));
  EXPECT_NEAR(wave.slope_low.x(), 20 * std::cos(1.0), 1e-10);
  EXPECT_NEAR(wave.slope_high.x(), 20.0, 1e-10);
  const Bounds distance(Material({"d"}), box_tet(Vec3(3, 4, 0), 1.0));
  EXPECT_NEAR(distance.slope_low.x(), 3 / std::sqrt(9 + 25 + 1), 1e-12);
  EXPECT_NEAR(distance.slope_high.x(), 4 / std::sqrt(16 + 16), 1e-12);
}

TEST(SlopeBounds, AreInfiniteAtAJumpAlone) {
  const Material material({"0.5*step(7.3, x) + x/50"});
  EXPECT_EQ(Bounds(material, box_tet(Vec3(7, 0, 0), 1.0)).slope_high.x(),
            std::numeric_limits<double>::infinity());
  EXPECT_NEAR(Bounds(material, box_tet(Vec3(7.5, 0, 0), 1.0)).slope_high.x(), 0.02, 1e-15);
  EXPECT_EQ(Bounds(material, box_tet(Vec3(7, 0, 0), 1.0)).slope_high.y(), 0.0);
}

}  // namespace
}  // namespace fgmesh::test
