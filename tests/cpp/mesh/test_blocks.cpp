// SPDX-License-Identifier: GPL-3.0-or-later
// Work on many parts of a mesh at the same time.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "mesh/blocks.hpp"
#include "mesh/odt_smoothing.hpp"
#include "mesh/swap_pass.hpp"
#include "mesh/threshold_relaxation.hpp"
#include "mesh/worst_first.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

/// Large enough to be cut into blocks.
struct LargeMesh : test::GridMesh {
  explicit LargeMesh(unsigned seed) : test::GridMesh(2.0, 26, test::linear(Vec3(0.4, 0.1, 0)), 0.06) {
    shake(0.3, seed);
  }
};

TEST(Blocks, OfASmallMeshAreOneOfAll) {
  const test::GridMesh mesh(2.0, 5);
  const Blocks blocks(mesh.state);
  EXPECT_EQ(blocks.cuts(), 1);
  EXPECT_EQ(blocks.count(0), 1);
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) EXPECT_TRUE(blocks.is_inner(0, v));
}

TEST(Blocks, AreOfEqualSizesAndKnowWhatIsInsideThem) {
  LargeMesh mesh(1);
  const TetComplex& complex = mesh.state.complex;
  const Blocks blocks(mesh.state);
  ASSERT_EQ(blocks.cuts(), 3);
  int inside_none = 0;
  std::vector<int> star;
  for (int cut = 0; cut < 2; ++cut) {
    std::vector<int> sizes(blocks.count(cut), 0);
    for (int v = 0; v < complex.vertex_slots(); ++v) {
      ++sizes[blocks.at(cut, v)];
      complex.star(v, star);
      const bool is_inner = std::all_of(star.begin(), star.end(), [&](int t) {
        const auto& around = complex.tet(t).vertex;
        return std::all_of(around.begin(), around.end(),
                           [&](int w) { return blocks.at(cut, w) == blocks.at(cut, v); });
      });
      ASSERT_EQ(blocks.is_inner(cut, v), is_inner);
      if (cut == 1) inside_none += !is_inner && !blocks.was_inner(cut, v);
    }
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    EXPECT_GE(sizes.size(), 2u);
    EXPECT_LE(*most - *least, static_cast<int>(sizes.size()));
  }
  EXPECT_LT(inside_none, complex.vertex_slots() / 12) << "the second cut is like the first";
}

TEST(Blocks, AreSweptVertexByVertex) {
  LargeMesh mesh(2);
  RunControl control;
  std::vector<int> visits(mesh.state.vertices.size(), 0);
  sweep_vertices(mesh.state, control, [&](int v, std::vector<int>&) { ++visits[v]; });
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<int>(visits.size()));
}

/// All that changes a mesh in blocks, by some number of threads.
TetMesh changed(int threads, std::vector<int>& counts) {
  LargeMesh mesh(3);
  RunControl control;
  with_threads(threads, [&] {
    counts.push_back(swap_pass(mesh.state, OdtEnergy(mesh.state), control));
    EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
    update_sizes(mesh.state, {0.1, 0.01, 0.4, 0.5});
    odt_sweep(mesh.state, 1.0, control);
    counts.push_back(relax_threshold(mesh.state, 0.055, control));
    const TetScore score(mesh.state, {});
    counts.push_back(WorstFirst(mesh.state, score).run(2, control));
  });
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_NEAR(test::volume_of(mesh.state), 8.0, 1e-10);
  counts.push_back(mesh.state.complex.tet_count());
  return mesh.state.to_tet_mesh();
}

TEST(Blocks, GiveTheSameMeshWhateverTheNumberOfThreads) {
  std::vector<int> counts, other_counts;
  const TetMesh mesh = changed(1, counts);
  for (int threads : {2, 0}) {
    other_counts.clear();
    const TetMesh other = changed(threads, other_counts);
    EXPECT_EQ(other_counts, counts);
    EXPECT_EQ(other.points, mesh.points);
    EXPECT_EQ(other.tets, mesh.tets);
  }
  EXPECT_GT(counts[0], 1000) << "swaps";
  EXPECT_EQ(counts.back(), static_cast<int>(mesh.tets.size()));
}

TEST(Blocks, LeaveNoSwapToAPassThatKnowsNothingOfThem) {
  // Swaps go on until the whole mesh is Delaunay, across the borders of blocks, too.
  LargeMesh mesh(4);
  RunControl control;
  const OdtEnergy energy(mesh.state);
  for (int pass = 0; pass < 40 && swap_pass(mesh.state, energy, control) > 0; ++pass) continue;
  Swapper swapper(mesh.state, energy);
  int left = 0;
  for (int t = 0; t < mesh.state.complex.slots(); ++t)
    if (mesh.state.complex.tet(t).alive()) left += swapper.improve(t);
  EXPECT_EQ(left, 0);
}

TEST(SortByPlace, KeepsTheMesh) {
  test::GridMesh mesh(2.0, 6);
  mesh.shake(0.3, 5);
  RunControl control;
  swap_pass(mesh.state, OdtEnergy(mesh.state), control);
  const auto corners = [&] {
    std::vector<std::array<double, 12>> tets;
    const TetMesh made_mesh = mesh.state.to_tet_mesh();
    for (const auto& tet : made_mesh.tets) {
      std::vector<std::array<double, 3>> places;
      for (int v : tet) {
        const Vec3& p = made_mesh.points[v];
        places.push_back({p.x(), p.y(), p.z()});
      }
      std::sort(places.begin(), places.end());
      auto& made = tets.emplace_back();
      for (int i = 0; i < 12; ++i) made[i] = places[i / 3][i % 3];
    }
    std::sort(tets.begin(), tets.end());
    return tets;
  };
  const auto jump = [&] {
    double sum = 0.0;
    for (int v = 1; v < mesh.state.complex.vertex_slots(); ++v)
      sum += (mesh.state.position(v) - mesh.state.position(v - 1)).norm();
    return sum;
  };
  const auto before = corners();
  const double jumps = jump();
  mesh.state.sort_by_place();
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_EQ(corners(), before);
  EXPECT_LT(jump(), 0.9 * jumps);
  EXPECT_EQ(mesh.state.complex.slots(), mesh.state.complex.tet_count());
}

}  // namespace
}  // namespace fgmesh
