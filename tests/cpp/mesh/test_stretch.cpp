// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/stretch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fields.hpp"

namespace fgmesh {
namespace {

Vertex vertex(const Vec3& position, const Vec3& stretch = Vec3::Zero()) {
  Vertex result;
  result.position = position;
  result.stretch = stretch;
  return result;
}

TEST(Stretch, CountsLengthsAlongItsAxisAsOftenAsItsFactorSays) {
  const Vertex a = vertex(Vec3::Zero(), Vec3(0, 0, 2)), b = vertex(Vec3::Zero(), Vec3(0, 0, 1));
  const Stretch stretch{&a, &b};
  EXPECT_DOUBLE_EQ(stretch.factor(), 2.5);
  EXPECT_DOUBLE_EQ(stretch.squared_length(Vec3(0, 0, 2)), 25.0);
  EXPECT_DOUBLE_EQ(stretch.squared_length(Vec3(3, 4, 0)), 25.0);
  EXPECT_TRUE(stretch.back(Vec3(3, 4, 5)).isApprox(Vec3(3, 4, 2)));
}

TEST(Stretch, IsNoneWhereNoVertexAsksForItOrTheyAskForOppositeWays) {
  const Vertex none = vertex(Vec3::Zero()), up = vertex(Vec3::Zero(), Vec3(0, 0, 2)),
               down = vertex(Vec3::Zero(), Vec3(0, 0, -2));
  for (const Stretch& stretch : {Stretch{&none}, Stretch{&up, &down}}) {
    EXPECT_EQ(stretch.factor(), 1.0);
    EXPECT_EQ(stretch.squared_length(Vec3(1, 2, 3)), 14.0);
    EXPECT_EQ(stretch.back(Vec3(1, 2, 3)), Vec3(1, 2, 3));
  }
}

TEST(StretchedTet, IsRegularWhereTheTetrahedronIsThatCompressed) {
  const Vec3 stretch(0, 0, 2);
  const auto place = [&](double x, double y, double z) { return vertex(Vec3(x, y, z / 3.0), stretch); };
  const StretchedTet tet(place(1, 1, 1), place(1, -1, -1), place(-1, 1, -1), place(-1, -1, 1));
  EXPECT_NEAR(std::abs(tet.flatness()), 16.0 / std::pow(48.0, 1.5), 1e-12);
  EXPECT_NEAR(std::abs(tet.volume), 16.0 / 3.0, 1e-12);
  EXPECT_NEAR(tet.squared_edges, 48.0, 1e-12);
}

TEST(WayInLayers, TakesASphereToOneOfARadiusAsMuchLarger) {
  constexpr double kRadius = 10.0, kFactor = 3.0;
  const auto on_sphere = [&](double angle) {
    const Vec3 normal(std::sin(angle), 0, std::cos(angle));
    return vertex(kRadius * normal, (kFactor - 1.0) * normal);
  };
  const Vertex from = on_sphere(0.0);
  for (const double angle : {0.02, 0.1, -0.2}) {
    const Vec3 centre(0, 0, -kFactor * kRadius);
    const double radius = (way_in_layers(from, on_sphere(angle)) - centre).norm();
    EXPECT_NEAR(radius, kFactor * kRadius, std::pow(angle, 4) * kRadius);
  }
  // A layer farther out is as much farther as the factor says.
  const Vertex above = vertex(Vec3(0, 0, kRadius + 1.0), from.stretch);
  EXPECT_TRUE(way_in_layers(from, above).isApprox(Vec3(0, 0, kFactor)));
}

SizingField sizing(double anisotropy, double max_size = 1000.0) {
  SizingField result;
  result.max_size = max_size;
  result.anisotropy = anisotropy;
  return result;
}

TEST(Pull, IsAsLargeAsAllowedAlongTheGradientOfALinearField) {
  const Vec3 slope(0.03, 0, 0.04);
  const Vec3 stretch = stretch_at(test::linear(slope), Vec3(1, 2, 3), slope, 2.0, sizing(4.0));
  EXPECT_TRUE(stretch.isApprox(3.0 * slope.normalized()));
}

TEST(Pull, LeavesElementsBelowTheLargestSize) {
  const Vec3 slope(0.05, 0, 0);
  const auto at_most = [&](double size, double most) {
    return stretch_at(test::linear(slope), Vec3::Zero(), slope, size, sizing(4.0, most)).norm();
  };
  EXPECT_NEAR(at_most(2.0, 5.0), 1.5, 1e-12);
  EXPECT_EQ(at_most(2.0, 2.0), 0.0);
  EXPECT_EQ(at_most(2.0, 1.0), 0.0);
}

TEST(Pull, IsLessTheMoreLevelSetsAreBent) {
  const test::FunctionField field = test::exponential(0.1);
  double before = -1.0;
  for (const double d : {1.0, 4.0, 10.0, 30.0, 200.0}) {
    const Vec3 gradient(-1.0, 0, 0);  // of any length: its way alone counts
    const double stretch = stretch_at(field, Vec3(d, 0, 0), gradient, 1.0, sizing(3.0)).norm();
    EXPECT_GE(stretch, before);
    // An element of size 1 along the gradient and as long across bulges by length^2 / 8 d.
    EXPECT_LT(std::pow(1.0 + stretch, 2) / (8.0 * d), d > 1.0 ? 0.12 : 0.2);
    before = stretch;
  }
  EXPECT_NEAR(before, 2.0, 1e-12);
}

TEST(Pull, IsNoneWithoutGradientOrAnisotropy) {
  const test::FunctionField field = test::linear(Vec3(1, 0, 0));
  EXPECT_TRUE(stretch_at(field, Vec3::Zero(), Vec3::Zero(), 1.0, sizing(3.0)).isZero());
  EXPECT_TRUE(stretch_at(field, Vec3::Zero(), Vec3(1, 0, 0), 1.0, sizing(1.0)).isZero());
  EXPECT_TRUE(stretch_at(field, Vec3::Zero(), Vec3(NAN, 0, 0), 1.0, sizing(3.0)).isZero());
}

}  // namespace
}  // namespace fgmesh
