// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/worst_first.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

double worst_score(const MeshState& state, const TetScore& score) {
  double worst = 1.0;
  for (int t = 0; t < state.complex.slots(); ++t)
    if (state.complex.tet(t).alive()) worst = std::min(worst, score(t));
  return worst;
}

TEST(TetScore, IsTheRatioToTheGoalMissedMost) {
  test::GridMesh mesh(1.0, 1, test::linear(Vec3(1, 0, 0)), 0.8);  // angles 45 to 90 degrees, variation 1
  const auto score = [&](const QualityGoal& goal) { return TetScore(mesh.state, goal)(0); };
  EXPECT_NEAR(score({15.0, 157.0, false}), 1.0, 1e-12);
  EXPECT_NEAR(score({60.0, 157.0, false}), 0.75, 1e-12);
  EXPECT_NEAR(score({15.0, 60.0, false}), (180.0 - 90.0) / (180.0 - 60.0), 1e-12);
  EXPECT_NEAR(score({15.0, 157.0, true}), 0.8, 1e-12);
  std::swap(mesh.state.vertices[0].position, mesh.state.vertices[7].position);
  EXPECT_LT(score({15.0, 157.0, false}), 0.0) << "turned over";
}

TEST(TetScore, IsTheSameWithAVertexImaginedOrPut) {
  test::GridMesh mesh(1.0, 2, test::linear(Vec3(1, 0, 0)), 0.25);
  const TetScore score(mesh.state, {});
  const int v = mesh.state.complex.tet(5).vertex[2];
  Vertex moved = mesh.state.vertices[v];
  moved.position += Vec3(0.11, -0.07, 0.05);
  moved.own.composition[0] += 0.1;
  const double imagined = score.with(5, v, moved);
  mesh.state.vertices[v] = moved;
  EXPECT_EQ(imagined, score(5));
}

class WorstFirstRun : public testing::TestWithParam<unsigned> {};

TEST_P(WorstFirstRun, NeverLowersTheWorstScore) {
  test::GridMesh mesh(2.0, 4, test::exponential(0.9), 0.1);
  mesh.shake(0.45, GetParam());
  const TetScore score(mesh.state, {});
  WorstFirst mender(mesh.state, score);
  RunControl control;
  double worst = worst_score(mesh.state, score);
  const double first = worst;
  for (int round = 0; round < 12; ++round) {
    if (round == 6) mender.allow_insertion();
    const int left = mender.run(1, control);
    ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "") << "round " << round;
    const double after = worst_score(mesh.state, score);
    EXPECT_GE(after, worst) << "round " << round;
    EXPECT_EQ(left, static_cast<int>(mender.bad_tets().size()));
    worst = after;
  }
  EXPECT_GT(worst, first) << "nothing was improved";
  EXPECT_NEAR(test::volume_of(mesh.state), 8.0, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Seed, WorstFirstRun, testing::Range(1u, 5u));

TEST(TetMender, ImprovesAVertexOnlyForTheBetter) {
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.45, 12);
  const TetScore score(mesh.state, {40.0, 120.0, false});
  TetMender mender(mesh.state, score, mesh.state.complex.own_site(), 1);
  std::vector<int> star;
  int improved = 0;
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    mesh.state.complex.star(v, star);
    const auto worst = [&] {
      double found = 1.0;
      for (const int t : star) found = std::min(found, score(t));
      return found;
    };
    const double before = worst();
    const Vec3 place = mesh.state.position(v);
    if (mender.improve_vertex(v)) {
      ++improved;
      EXPECT_GT(worst(), before);
    } else {
      EXPECT_EQ(mesh.state.position(v), place);
    }
  }
  EXPECT_GT(improved, 20);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
}

TEST(WorstFirst, LeavesFrozenVerticesInPlace) {
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.45, 13);
  for (std::size_t v = 0; v < mesh.state.vertices.size(); v += 2) mesh.state.vertices[v].frozen = true;
  const std::vector<Vertex> before = mesh.state.vertices;
  const TetScore score(mesh.state, {});
  WorstFirst mender(mesh.state, score);
  RunControl control;
  mender.run(5, control);
  for (std::size_t v = 0; v < before.size(); v += 2)
    EXPECT_EQ(mesh.state.vertices[v].position, before[v].position);
}

TEST(WorstFirst, ListsTheWorstTetrahedronFirst) {
  test::GridMesh mesh(2.0, 3);
  mesh.shake(0.45, 14);
  const TetScore score(mesh.state, {30.0, 130.0, false});
  const std::vector<int> bad = WorstFirst(mesh.state, score).bad_tets(0.9);
  ASSERT_GT(bad.size(), 3u);
  for (std::size_t i = 1; i < bad.size(); ++i) EXPECT_LE(score(bad[i - 1]), score(bad[i]));
  EXPECT_LT(score(bad.back()), 0.9);
  EXPECT_EQ(score(bad.front()), worst_score(mesh.state, score));
}

TEST(WorstFirst, RightsATetrahedronThatIsTurnedOver) {
  test::GridMesh mesh(3.0, 3);
  for (Vertex& vertex : mesh.state.vertices)
    if (vertex.position == Vec3(1, 1, 1)) vertex.position = Vec3(1.9, 0.5, 1.5);
  const TetScore score(mesh.state, {});
  WorstFirst mender(mesh.state, score);
  ASSERT_FALSE(mender.bad_tets(0.0).empty());
  RunControl control;
  EXPECT_EQ(mender.run(20, control), 0);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_NEAR(test::volume_of(mesh.state), 27.0, 1e-11);
}

}  // namespace
}  // namespace fgmesh
