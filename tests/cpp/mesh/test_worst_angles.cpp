// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "mesh/worst_angles.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

double smallest_angle(const MeshState& state) {
  double largest_cosine = -1.0;
  for (int t = 0; t < state.complex.slots(); ++t) {
    const Tet& tet = state.complex.tet(t);
    if (!tet.alive()) continue;
    const auto at = [&](int i) -> const Vec3& { return state.position(tet.vertex[i]); };
    for (const double cosine : dihedral_cosines(at(0), at(1), at(2), at(3)))
      largest_cosine = std::max(largest_cosine, cosine);
  }
  return angle_of(largest_cosine);
}

class WorstAngles : public testing::TestWithParam<unsigned> {};

TEST_P(WorstAngles, AreRaisedAboveTenDegrees) {
  test::GridMesh mesh(2.0, 4, test::linear(Vec3(0.1, 0, 0)), 1.0);
  mesh.shake(0.4, GetParam());
  ASSERT_LT(smallest_angle(mesh.state), 5.0);
  RunControl control;
  EXPECT_GT(raise_worst_angles(mesh.state, {}, control), 0);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_GE(smallest_angle(mesh.state), 10.0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, WorstAngles, testing::Values(1u, 2u, 3u));

TEST(WorstAngles, AGoodMeshStaysAsItIs) {
  test::GridMesh mesh(2.0, 4, test::linear(Vec3(0.1, 0, 0)), 1.0);
  const int tets = mesh.state.complex.tet_count();
  RunControl control;
  EXPECT_EQ(raise_worst_angles(mesh.state, {}, control), 0);
  EXPECT_EQ(mesh.state.complex.tet_count(), tets);
}

/// Frozen vertices cannot be moved: what cannot be made better is put back to the last vertex.
TEST(WorstAngles, WhatDoesNotHelpIsUndone) {
  test::GridMesh mesh(2.0, 1, test::linear(Vec3(0.1, 0, 0)), 1.0);
  mesh.state.min_size = 10.0;  // no edge may be split
  for (Vertex& vertex : mesh.state.vertices) vertex.frozen = true;
  const std::vector<Vertex> before = mesh.state.vertices;
  RunControl control;
  QualityGoal hopeless;
  hopeless.smallest_angle = 80.0;
  hopeless.material = false;
  EXPECT_EQ(raise_worst_angles(mesh.state, hopeless, control), 0);
  ASSERT_EQ(mesh.state.vertices.size(), before.size());
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_EQ(mesh.state.vertices[v].position, before[v].position);
}

}  // namespace
}  // namespace fgmesh
