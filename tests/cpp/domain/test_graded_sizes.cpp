// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "domain/graded_sizes.hpp"

namespace fgmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(GradedSizes, NothingAsksForLess) {
  EXPECT_EQ(GradedSizes({}, 0.5).at(Vec3(1, 2, 3), 7.0), 7.0);
  const GradedSizes large({{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 9.0}}, 0.5);
  EXPECT_EQ(large.at(Vec3(0.2, 0.2, 0), 7.0), 7.0);
}

TEST(GradedSizes, GrowsWithTheDistanceToATriangle) {
  const GradedSizes sizes({{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)}, 1.0}}, 0.5);
  const auto distance = [&](const Vec3& p) { return (sizes.at(p, kInfinity) - 1.0) / 0.5; };
  EXPECT_NEAR(distance(Vec3(1, 1, 0)), 0.0, 1e-14);
  EXPECT_NEAR(distance(Vec3(1, 1, 3)), 3.0, 1e-14);                 // above it
  EXPECT_NEAR(distance(Vec3(1, 1, -3)), 3.0, 1e-14);                // below it
  EXPECT_NEAR(distance(Vec3(2, -3, 4)), 5.0, 1e-14);                // beside an edge
  EXPECT_NEAR(distance(Vec3(4, 4, 0)), 4.0 / std::sqrt(2), 1e-14);  // beside the longest
  EXPECT_NEAR(distance(Vec3(-2, -3, 6)), 7.0, 1e-14);               // beyond a corner
}

TEST(GradedSizes, GrowsWithTheDistanceToASegment) {
  const GradedSizes sizes({{{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(4, 0, 0)}, 0.0}}, 1.0);
  EXPECT_NEAR(sizes.at(Vec3(1, 3, 4), kInfinity), 5.0, 1e-14);
  EXPECT_NEAR(sizes.at(Vec3(6, 3, 6), kInfinity), 7.0, 1e-14);
  EXPECT_NEAR(sizes.at(Vec3(3, 0, 0), kInfinity), 0.0, 1e-14);
}

TEST(GradedSizes, TheLeastOfManyCounts) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0.0, 10.0);
  const auto point = [&] { return Vec3(number(random), number(random), number(random)); };
  std::vector<SizeSource> sources;
  for (int i = 0; i < 500; ++i) {
    const Vec3 place = point();
    sources.push_back({{place, place, place}, 0.2 * number(random)});
  }
  const GradedSizes sizes(sources, 0.6);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = point();
    double least = 3.0;
    for (const SizeSource& source : sources)
      least = std::min(least, source.size + 0.6 * (p - source.corner[0]).norm());
    EXPECT_NEAR(sizes.at(p, 3.0), least, 1e-12);
  }
}

}  // namespace
}  // namespace fgmesh
