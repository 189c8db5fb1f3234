// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "domain/crease_sizing.hpp"

namespace fgmesh {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Only the curves of a boundary: all that sizes of creases depend on.
struct Curves : SampledBoundary {
  int add_point(const Vec3& p) {
    points.push_back(p);
    return static_cast<int>(points.size()) - 1;
  }

  void add_line(int from, int to, int segments) {
    Curve curve;
    curve.edge = static_cast<int>(curves.size()) + 1;
    curve.points.push_back(from);
    for (int i = 1; i < segments; ++i) {
      const double s = static_cast<double>(i) / segments;
      curve.points.push_back(add_point((1.0 - s) * points[from] + s * points[to]));
    }
    curve.points.push_back(to);
    curves.push_back(curve);
  }

  void add_line(const Vec3& from, const Vec3& to, int segments) {
    const int first = add_point(from), last = add_point(to);
    add_line(first, last, segments);
  }

  void add_circle(double radius, const Vec3& centre, int segments) {
    Curve curve;
    curve.edge = static_cast<int>(curves.size()) + 1;
    for (int i = 0; i < segments; ++i) {
      const double angle = 2.0 * kPi * i / segments;
      curve.points.push_back(add_point(centre + radius * Vec3(std::cos(angle), std::sin(angle), 0)));
    }
    curve.points.push_back(curve.points.front());
    curves.push_back(curve);
  }

  /// Sizes at the samples of one curve.
  std::vector<double> sizes(int curve, double asked) const {
    const CreaseSizing sizing(*this, asked);
    std::vector<double> result;
    for (const int p : curves[curve].points) result.push_back(sizing.on_curve(curve, points[p]));
    return result;
  }
};

TEST(CreaseSizing, PutsEightSegmentsOnACircle) {
  for (const double radius : {1e-3, 1.0, 1e4}) {
    for (const int samples : {32, 100, 501}) {
      Curves curves;
      curves.add_circle(radius, Vec3(3, 4, 5) * radius, samples);
      for (const double size : curves.sizes(0, 50.0 * radius)) {
        EXPECT_LE(2.0 * kPi * radius / size, 8.2);
        EXPECT_GE(2.0 * kPi * radius / size, 7.5);
      }
    }
  }
}

TEST(CreaseSizing, LeavesAStraightLineAtTheSizeAskedFor) {
  Curves curves;
  curves.add_line(Vec3(0, 0, 0), Vec3(10, 20, 5), 40);
  for (const double size : curves.sizes(0, 3.0)) EXPECT_DOUBLE_EQ(size, 3.0);
  const CreaseSizing sizing(curves, 3.0);
  EXPECT_DOUBLE_EQ(sizing.at_corner(Vec3(10, 20, 5)), 3.0);
  EXPECT_DOUBLE_EQ(sizing.at_corner(Vec3(1, 1, 1)), 3.0) << "no corner of any curve";
}

TEST(CreaseSizing, NeverExceedsTheSizeAskedFor) {
  Curves curves;
  curves.add_circle(10.0, Vec3::Zero(), 64);
  for (const double size : curves.sizes(0, 0.5)) EXPECT_DOUBLE_EQ(size, 0.5);
}

TEST(CreaseSizing, KeepsBelowTheDistanceOfAnotherCrease) {
  // Protecting balls around the two edges of a thin wall must not reach across it.
  constexpr double kWall = 0.2;
  Curves curves;
  curves.add_line(Vec3(0, 0, 0), Vec3(10, 0, 0), 50);
  curves.add_line(Vec3(0, kWall, 0), Vec3(10, kWall, 0), 7);
  for (const int curve : {0, 1}) {
    for (const double size : curves.sizes(curve, 3.0)) {
      EXPECT_LE(size, kWall * (1.0 + 1e-12));
      EXPECT_GE(size, 0.5 * kWall);
    }
  }
}

TEST(CreaseSizing, IsNotHinderedByACreaseThatItTouches) {
  Curves curves;
  const int corner = curves.add_point(Vec3(0, 0, 0));
  const int x = curves.add_point(Vec3(10, 0, 0)), y = curves.add_point(Vec3(0, 10, 0));
  curves.add_line(corner, x, 40);
  curves.add_line(y, corner, 40);
  for (const double size : curves.sizes(0, 2.0)) EXPECT_DOUBLE_EQ(size, 2.0);
}

TEST(CreaseSizing, OfACornerIsTheLeastOfItsCurves) {
  Curves curves;
  const int corner = curves.add_point(Vec3(0, 0, 0));
  const int x = curves.add_point(Vec3(10, 0, 0)), y = curves.add_point(Vec3(0, 10, 0));
  curves.add_line(corner, x, 40);
  curves.add_line(corner, y, 40);
  curves.add_line(Vec3(0.3, 0, 0.1), Vec3(10, 0, 0.1), 40);  // close to the first, from its start on
  const CreaseSizing sizing(curves, 2.0);
  const double at_first = sizing.on_curve(0, Vec3::Zero()), at_second = sizing.on_curve(1, Vec3::Zero());
  EXPECT_LT(at_first, 0.4);
  EXPECT_LE(sizing.at_corner(Vec3::Zero()), std::min(at_first, at_second));
  EXPECT_GT(sizing.at_corner(Vec3::Zero()), 0.0);
}

TEST(CreaseSizing, GrowsSlowlyAlongACrease) {
  constexpr double kMostGrowth = 0.5 + 1e-9;
  Curves curves;
  curves.add_line(Vec3(0, 0, 0), Vec3(20, 0, 0), 400);
  curves.add_line(Vec3(10, 0.1, -1), Vec3(10, 0.1, 1), 20);  // passes it closely in the middle
  const std::vector<double> sizes = curves.sizes(0, 8.0);
  const std::vector<int>& line = curves.curves[0].points;
  EXPECT_LE(*std::min_element(sizes.begin(), sizes.end()), 0.1 + 1e-12);
  EXPECT_GT(sizes.front(), 3.0) << "ten millimetres away there is no reason to be small";
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double distance = (curves.points[line[i]] - curves.points[line[i - 1]]).norm();
    EXPECT_LE(std::abs(sizes[i] - sizes[i - 1]), kMostGrowth * distance);
  }
}

}  // namespace
}  // namespace fgmesh
