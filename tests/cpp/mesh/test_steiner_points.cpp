// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "mesh/steiner_points.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

/// Between x = 0 and x = 1.
bool jumps(std::function<double(double)> f, double threshold = 0.1) {
  return jumps_between(test::along_x(std::move(f), [](double) { return 0.0; }), Vec3(0, 2, 3), Vec3(1, 2, 3),
                       threshold);
}

TEST(JumpsBetween, FindsAStepWhereverItIs) {
  for (const double place : {1e-6, 0.1, 0.5, 1.0 / 3.0, 0.999999}) {
    EXPECT_TRUE(jumps([=](double x) { return x > place ? 0.9 : 0.1; })) << place;
    EXPECT_TRUE(jumps([=](double x) { return x >= place ? 0.1 : 0.9; })) << place;
    EXPECT_TRUE(jumps([=](double x) { return 0.3 * x + (x > place ? 0.5 : 0.0); }))
        << "on a slope, " << place;
  }
}

TEST(JumpsBetween, IsNotDeceivedByWhatIsSteepButContinuous) {
  EXPECT_FALSE(jumps([](double x) { return x; }));
  EXPECT_FALSE(jumps([](double x) { return std::sqrt(x); })) << "its slope is infinite at an end";
  EXPECT_FALSE(jumps([](double x) { return std::sqrt(std::abs(x - 0.5)); }));
  EXPECT_FALSE(jumps([](double x) { return std::cbrt(x); }));
  for (const double steepness : {10.0, 1e3, 1e5}) {
    EXPECT_FALSE(jumps([=](double x) { return 0.5 + 0.5 * std::tanh(steepness * (x - 0.37)); })) << steepness;
  }
  EXPECT_FALSE(jumps([](double) { return 0.25; }));
}

TEST(JumpsBetween, LeavesStepsBelowTheThresholdAlone) {
  const auto step = [](double x) { return x > 0.4 ? 0.55 : 0.5; };
  EXPECT_FALSE(jumps(step, 0.1));
  EXPECT_TRUE(jumps(step, 0.04));
}

TEST(CountAbove, CountsTetrahedra) {
  test::GridMesh mesh(1.0, 4, test::linear(Vec3(1, 0, 0)));
  EXPECT_EQ(count_above(mesh.state, 0.2), 6 * 64);
  EXPECT_EQ(count_above(mesh.state, 0.26), 0);
}

TEST(SteinerPoints, BringTheVariationDown) {
  test::GridMesh mesh(1.0, 2, test::linear(Vec3(1, 0, 0)));
  RunControl control;
  double largest = test::largest_variation(mesh.state);
  int rounds = 0;
  while (count_above(mesh.state, 0.1) > 0 && ++rounds < 30) {
    const int before = test::vertex_count(mesh.state);
    const int inserted = insert_steiner_points(mesh.state, 0.1, 1000000, control);
    ASSERT_GT(inserted, 0);
    EXPECT_EQ(test::vertex_count(mesh.state), before + inserted);
    ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "");
    EXPECT_LE(test::largest_variation(mesh.state), largest);
    largest = test::largest_variation(mesh.state);
  }
  EXPECT_EQ(count_above(mesh.state, 0.1), 0);
  EXPECT_NEAR(test::volume_of(mesh.state), 1.0, 1e-12);
}

TEST(SteinerPoints, AreNoMoreThanAsked) {
  test::GridMesh mesh(1.0, 3, test::linear(Vec3(1, 0, 0)));
  RunControl control;
  EXPECT_LE(insert_steiner_points(mesh.state, 0.1, 5, control), 5);
  EXPECT_LE(test::vertex_count(mesh.state), 64 + 5);
}

TEST(SteinerPoints, HalveNoEdgeBelowTheSmallestSize) {
  // The edges of the grid are 1/2, 1/sqrt 2 and sqrt 3 / 2 long.
  const test::FunctionField field = test::linear(Vec3(1, 0, 0));
  RunControl control;
  test::GridMesh none(1.0, 2, field), diagonals(1.0, 2, field);
  none.state.min_size = 0.45;
  diagonals.state.min_size = 0.3;
  EXPECT_EQ(insert_steiner_points(none.state, 0.1, 1000000, control), 0);
  EXPECT_GT(insert_steiner_points(diagonals.state, 0.1, 1000000, control), 0);
  for (const Vec3& p : diagonals.state.to_tet_mesh().points) {
    int off_grid = 0;
    for (int axis = 0; axis < 3; ++axis) off_grid += 2.0 * p[axis] != std::round(2.0 * p[axis]);
    EXPECT_NE(off_grid, 1) << "the middle of an edge of length 1/2";
  }
}

TEST(SteinerPoints, DoNotChaseAJump) {
  test::GridMesh mesh(1.0, 4, test::jump(0.4));
  RunControl control;
  EXPECT_GT(count_above(mesh.state, 0.1), 0);
  EXPECT_EQ(insert_steiner_points(mesh.state, 0.1, 1000000, control), 0);
}

}  // namespace
}  // namespace fgmesh
