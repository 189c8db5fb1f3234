// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mesh/steiner_points.hpp"
#include "mesh/threshold_relaxation.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

class ThresholdRelaxation : public testing::TestWithParam<double> {};

TEST_P(ThresholdRelaxation, TurnsNoTetrahedronOverAndMakesNoneTheWorst) {
  // From hardly a tetrahedron above the threshold to nearly all of them.
  const double alpha = GetParam();
  test::GridMesh mesh(2.0, 5, test::exponential(alpha), 0.1);
  mesh.shake(0.25, 1);
  RunControl control;
  double largest = test::largest_variation(mesh.state);
  ASSERT_GT(largest, 0.1);
  for (int sweep = 0; sweep < 25; ++sweep) {
    const int above = count_above(mesh.state, 0.1);
    EXPECT_EQ(relax_threshold(mesh.state, 0.093, control), above);
    ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "") << "sweep " << sweep;
    EXPECT_LE(test::largest_variation(mesh.state), std::max(largest, 0.1) * (1.0 + 1e-12));
    largest = test::largest_variation(mesh.state);
  }
  EXPECT_NEAR(test::volume_of(mesh.state), 8.0, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Alpha, ThresholdRelaxation, testing::Values(0.3, 0.6, 1.5, 8.0),
                         [](const auto& info) { return "N" + std::to_string(info.index); });

TEST(ThresholdRelaxationAlone, MendsWhatIsALittleAbove) {
  // Cells of 0.25 on a slope of 0.4 vary by 0.1; shaken, a part of them by more. On average there is room.
  test::GridMesh mesh(2.0, 8, test::linear(Vec3(0.36, 0, 0)), 0.1);
  mesh.shake(0.12, 2);
  RunControl control;
  const int before = count_above(mesh.state, 0.1);
  ASSERT_GT(before, 50);
  for (int sweep = 0; sweep < 40; ++sweep) relax_threshold(mesh.state, 0.093, control);
  EXPECT_LT(count_above(mesh.state, 0.1), before / 10);
}

TEST(ThresholdRelaxationAlone, LeavesAMeshAloneThatKeepsTheThreshold) {
  test::GridMesh mesh(2.0, 4, test::linear(Vec3(0.1, 0, 0)), 0.1);
  const std::vector<Vertex> before = mesh.state.vertices;
  RunControl control;
  EXPECT_EQ(relax_threshold(mesh.state, 0.093, control), 0);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_EQ(mesh.state.vertices[v].position, before[v].position);
}

TEST(ThresholdRelaxationAlone, IsCalmWhereTheGradientVanishesAcrossAJump) {
  test::GridMesh mesh(1.0, 4, test::jump(0.4));
  RunControl control;
  const int above = count_above(mesh.state, 0.1);
  EXPECT_GT(above, 0);
  EXPECT_EQ(relax_threshold(mesh.state, 0.093, control), above);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
}

}  // namespace
}  // namespace fgmesh
