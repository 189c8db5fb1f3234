// SPDX-License-Identifier: GPL-3.0-or-later
// Long random sequences of changes, none of which may leave the mesh inconsistent.
#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "mesh/edge_collapse.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/swap.hpp"
#include "mesh/tet_score.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

/// Costs drawn anew each time: swaps happen at random, wherever they may.
class RandomCost final : public SwapObjective {
 public:
  RandomCost(const MeshState& state, std::mt19937& random) : state_(state), random_(random) {}
  double cost(const std::array<int, 4>& v) const override {
    if (!is_positive(state_.position(v[0]), state_.position(v[1]), state_.position(v[2]),
                     state_.position(v[3])))
      return std::numeric_limits<double>::infinity();
    return std::uniform_real_distribution<double>(0.0, 1.0)(random_);
  }
  double join(double a, double b) const override { return std::max(a, b); }
  double nothing() const override { return std::numeric_limits<double>::infinity(); }

 private:
  const MeshState& state_;
  std::mt19937& random_;
};

struct Counts {
  int edges_removed = 0, faces_removed = 0, splits = 0, collapses = 0;
};

int random_tet(const MeshState& state, std::mt19937& random) {
  int t;
  do {
    t = std::uniform_int_distribution<int>(0, state.complex.slots() - 1)(random);
  } while (!state.complex.tet(t).alive());
  return t;
}

void change(MeshState& state, std::mt19937& random, Counts& counts) {
  const RandomCost cost(state, random);
  const TetScore score(state, {1.0, 179.0, false});
  Swapper swapper(state, cost);
  const int t = random_tet(state, random);
  const std::array<int, 4> v = state.complex.tet(t).vertex;
  const auto& edge = kEdgeVertices[random() % 6];
  const int a = v[edge[0]], b = v[edge[1]];
  switch (random() % 8) {
    case 0:
      counts.splits += split_edge(state, a, b, t) >= 0;
      break;
    case 1:
      counts.collapses += collapse_edge(state, a, b, score, 0.0);
      break;
    case 2:
    case 3:
    case 4:
      counts.faces_removed += swapper.remove_face(t, static_cast<int>(random() % 4));
      break;
    default:
      counts.edges_removed += swapper.remove_edge(a, b, t);
  }
}

class RandomChanges : public testing::TestWithParam<unsigned> {};

TEST_P(RandomChanges, KeepTheMeshConsistent) {
  test::GridMesh mesh(2.0, 3);
  std::mt19937 random(GetParam());
  mesh.shake(0.25, GetParam());
  mesh.state.chord_limit = 1e-9;
  ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  Counts counts;
  for (int step = 0; step < 1500; ++step) {
    const int made = counts.splits + counts.collapses + counts.edges_removed + counts.faces_removed;
    change(mesh.state, random, counts);
    if (made == counts.splits + counts.collapses + counts.edges_removed + counts.faces_removed) continue;
    ASSERT_EQ(test::find_fault(mesh.state.complex), "") << "after step " << step;
    ASSERT_NEAR(test::volume_of(mesh.state), 8.0, 1e-11) << "after step " << step;
    if (step % 10 == 0) {
      ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "") << "after step " << step;
    }
  }
  ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_GT(counts.splits, 50);
  EXPECT_GT(counts.collapses, 5);
  EXPECT_GT(counts.edges_removed, 50);
  EXPECT_GT(counts.faces_removed, 5);
}

INSTANTIATE_TEST_SUITE_P(Seed, RandomChanges, testing::Range(1u, 6u));

}  // namespace
}  // namespace fgmesh
