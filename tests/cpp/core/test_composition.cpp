// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "core/composition.hpp"

namespace fgmesh {
namespace {

TEST(CompositionVariation, IsTheLargestDifferenceOfTwoVertices) {
  std::array<double, 4> value = {0.1, 0.35, 0.6, 0.2};
  std::sort(value.begin(), value.end());
  do {
    EXPECT_DOUBLE_EQ(composition_variation({value[0]}, {value[1]}, {value[2]}, {value[3]}), 0.5);
  } while (std::next_permutation(value.begin(), value.end()));
  EXPECT_EQ(composition_variation({0.3}, {0.3}, {0.3}, {0.3}), 0.0);
}

TEST(CompositionVariation, OfThreeConstituentsIsThatOfTheWholeVectors) {
  // From all of the first to all of the second, or of the last.
  EXPECT_DOUBLE_EQ(difference({1.0, 0.0}, {0.0, 1.0}), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(difference({1.0, 0.0}, {0.0, 0.0}), std::sqrt(2.0));
  // (0.2, 0.3, 0.5) and (0.3, 0.1, 0.6)
  EXPECT_DOUBLE_EQ(difference({0.2, 0.3}, {0.3, 0.1}), std::sqrt(0.01 + 0.04 + 0.01));
  const Composition a = {0.2, 0.3}, b = {0.25, 0.2}, c = {0.3, 0.1};
  EXPECT_DOUBLE_EQ(composition_variation(a, b, b, c), difference(a, c));
  EXPECT_DOUBLE_EQ(composition_variation(b, c, a, b), difference(a, c));
}

/// Three constituents whose fractions are linear.
const CompositionGradient kGradient = {Vec3(0.1, 0.02, 0.0), Vec3(-0.03, 0.05, 0.08)};

Composition at(const Vec3& p) { return {0.3 + kGradient[0].dot(p), 0.2 + kGradient[1].dot(p)}; }

TEST(CompositionGradient, OfTheSteepestWayIsSteeperThanAnyOther) {
  std::mt19937 random(5);
  std::normal_distribution<double> number;
  const Vec3 steep = steepest(kGradient);
  EXPECT_NEAR(difference(at(Vec3::Zero()), at(steep.normalized())), steep.norm(), 1e-14);
  for (int i = 0; i < 100; ++i) {
    const Vec3 way = Vec3(number(random), number(random), number(random)).normalized();
    EXPECT_LE(difference(at(Vec3::Zero()), at(way)), steep.norm() + 1e-14);
    EXPECT_NEAR(magnitude(change_along(kGradient, way)), difference(at(Vec3::Zero()), at(way)), 1e-14);
  }
  EXPECT_EQ(steepest({Vec3(1, 2, 3)}), Vec3(1, 2, 3));
}

TEST(CompositionGradient, TowardsAnotherCompositionRaisesTheDifference) {
  const Vec3 p(0.1, 0.2, 0.3);
  const Composition from = at(Vec3::Zero()), to = at(p);
  const Vec3 gradient = gradient_towards(kGradient, from, to);
  // d/ds || M(p + s way) - M(0) || by differences.
  for (const Vec3& way : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    constexpr double kStep = 1e-6;
    const double slope =
        (difference(at(p + kStep * way), from) - difference(at(p - kStep * way), from)) / (2.0 * kStep);
    EXPECT_NEAR(gradient.dot(way), slope, 1e-8);
  }
  EXPECT_EQ(gradient_towards({Vec3(1, 0, 0)}, {0.5}, {0.2}), Vec3(-1, 0, 0));
  EXPECT_EQ(gradient_towards({Vec3(1, 0, 0)}, {0.2}, {0.5}), Vec3(1, 0, 0));
}

}  // namespace
}  // namespace fgmesh
