// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <vector>

#include "mesh/swap.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

double energy_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double squared = 0.0;
  const std::vector<Vec3> p = {a, b, c, d};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) squared += (p[i] - p[j]).squaredNorm();
  return std::abs((b - a).cross(c - a).dot(d - a)) * squared;
}

double energy_of(const MeshState& state) {
  double sum = 0.0;
  for (const auto& [a, b, c, d] : state.to_tet_mesh().tets)
    sum += energy_of(state.position(a), state.position(b), state.position(c), state.position(d));
  return sum;
}

/// The least energy that any mesh of these points has: that of CGAL's Delaunay triangulation.
double least_energy(const MeshState& state) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Delaunay_triangulation_3<Kernel> delaunay;
  for (const Vec3& p : state.to_tet_mesh().points) delaunay.insert({p.x(), p.y(), p.z()});
  double sum = 0.0;
  for (auto cell = delaunay.finite_cells_begin(); cell != delaunay.finite_cells_end(); ++cell) {
    std::vector<Vec3> p;
    for (int i = 0; i < 4; ++i) {
      const auto& place = cell->vertex(i)->point();
      p.emplace_back(place.x(), place.y(), place.z());
    }
    sum += energy_of(p[0], p[1], p[2], p[3]);
  }
  return sum;
}

class OdtSwaps : public testing::TestWithParam<unsigned> {};

TEST_P(OdtSwaps, LowerTheEnergyUntilTheMeshIsDelaunay) {
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.3, GetParam());
  const OdtEnergy objective(mesh.state);
  Swapper swapper(mesh.state, objective);
  double energy = energy_of(mesh.state);
  const double least = least_energy(mesh.state);
  ASSERT_GT(energy, 1.001 * least) << "already Delaunay: nothing is tested";
  for (int pass = 0; pass < 30; ++pass) {
    const int swaps = swapper.pass();
    const double after = energy_of(mesh.state);
    EXPECT_LE(after, energy * (1.0 + 1e-12));
    ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "");
    ASSERT_NEAR(test::volume_of(mesh.state), 8.0, 1e-11);
    energy = after;
    if (swaps == 0) break;
  }
  EXPECT_NEAR(energy, least, 1e-4 * least);
}

INSTANTIATE_TEST_SUITE_P(Seed, OdtSwaps, testing::Range(1u, 7u));

TEST(Swapper, DoesNotTouchWhatIsDelaunay) {
  test::GridMesh mesh(2.0, 3);
  mesh.shake(0.3, 3);
  const OdtEnergy objective(mesh.state);
  Swapper swapper(mesh.state, objective);
  while (swapper.pass() > 0) continue;
  const auto before = mesh.state.to_tet_mesh().tets;
  EXPECT_EQ(swapper.pass(), 0);
  EXPECT_EQ(mesh.state.to_tet_mesh().tets, before);
}

TEST(Swapper, MakesNothingThatVariesMoreThanAllowed) {
  constexpr double kMost = 0.35;
  test::GridMesh mesh(2.0, 4, test::linear(Vec3(0.5, 0, 0)), kMost);
  mesh.shake(0.15, 5);
  ASSERT_LT(test::largest_variation(mesh.state), kMost) << "nothing may be above at the start";
  const OdtEnergy free(mesh.state), bounded(mesh.state, kMost);
  Swapper swapper(mesh.state, bounded);
  int swaps = 0;
  for (int pass = 0; pass < 10; ++pass) swaps += swapper.pass();
  EXPECT_GT(swaps, 0);
  EXPECT_LE(test::largest_variation(mesh.state), kMost);
}

TEST(Swapper, KeepsCreasesAndInterfaces) {
  const test::BoxSolid solid({Vec3::Zero(), Vec3::Constant(2.0)});
  const test::FunctionField field = test::constant(0.5);
  MeshState state(solid, field, 0.1, 3.0);
  const TetMesh grid = test::box_grid(2.0, 4, 2);
  test::load(state, grid, 0.5);
  const OdtEnergy objective(state);
  Swapper swapper(state, objective);
  for (int pass = 0; pass < 5; ++pass) swapper.pass();
  EXPECT_EQ(test::find_fault(state, solid), "");
  const TetMesh after = state.to_tet_mesh();
  double area = 0.0;
  for (std::size_t f = 0; f < after.triangles.size(); ++f) {
    if (after.triangle_faces[f] != 7) continue;
    const auto& [a, b, c] = after.triangles[f];
    area += 0.5 * area_vector(after.points[a], after.points[b], after.points[c]).norm();
    for (const int v : {a, b, c}) EXPECT_EQ(after.points[v].x(), 1.0);
  }
  EXPECT_NEAR(area, 4.0, 1e-12);
  EXPECT_EQ(after.edges.size(), grid.edges.size());
}

}  // namespace
}  // namespace fgmesh
