// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes, and whole sweeps of ODT smoothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/odt_smoothing.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

/// The largest of (difference of size) / (growth * distance) over the edges of the mesh.
double steepest_growth(const MeshState& state, double growth) {
  double steepest = 0.0;
  for (int t = 0; t < state.complex.slots(); ++t) {
    for (const auto& [i, j] : kEdgeVertices) {
      const Vertex &a = state.vertices[state.complex.tet(t).vertex[i]],
                   &b = state.vertices[state.complex.tet(t).vertex[j]];
      const double distance = (a.position - b.position).norm();
      steepest = std::max(steepest, std::abs(a.size - b.size) / (growth * distance));
    }
  }
  return steepest;
}

TEST(UpdateSizes, LetsSizesGrowOnlyAsFastAsAsked) {
  // The size wanted is small in one corner only; whichever it is, the bound must reach across the whole mesh.
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 centre(corner & 1 ? 10 : 0, corner & 2 ? 10 : 0, corner & 4 ? 10 : 0);
    test::GridMesh mesh(10.0, 12, test::exponential(3.0, centre));
    const SizingField sizing = {0.1, 0.01, 30.0, 0.5};
    update_sizes(mesh.state, sizing);
    EXPECT_LE(steepest_growth(mesh.state, 0.5), 1.0 + 1e-5) << "corner " << corner;
    for (const Vertex& vertex : mesh.state.vertices) {
      EXPECT_LE(vertex.size, sizing.at(vertex.own.gradient[0]) * (1.0 + 1e-12));
      EXPECT_GE(vertex.size, 0.01);
    }
  }
}

TEST(UpdateSizes, IsTheSizingFieldWhereThatIsSmooth) {
  test::GridMesh mesh(8.0, 5, test::linear(Vec3(0.02, 0.03, 0.06)));  // |grad f| = 0.07
  update_sizes(mesh.state, {0.035, 0.01, 9.0, 0.5});
  for (const Vertex& vertex : mesh.state.vertices) EXPECT_NEAR(vertex.size, 0.5, 1e-12);
}

TEST(OdtSweep, LeadsAShakenMeshToBetterShapes) {
  test::GridMesh mesh(2.0, 5);
  mesh.shake(0.3, 8);
  const AngleRange before = test::angle_range(mesh.state);
  RunControl control;
  for (int sweep = 0; sweep < 15; ++sweep) {
    update_sizes(mesh.state, {0.1, 0.01, 0.4, 0.5});
    odt_sweep(mesh.state, 1.0, control);
    ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "") << "sweep " << sweep;
  }
  EXPECT_NEAR(test::volume_of(mesh.state), 8.0, 1e-11);
  EXPECT_EQ(test::vertex_count(mesh.state), 216);
  EXPECT_LT(before.smallest, 8.0);
  // Not the worst angle, of which ODT knows nothing, but most of them get better.
  int small = 0;
  for (int t = 0; t < mesh.state.complex.slots(); ++t) {
    if (!mesh.state.complex.tet(t).alive()) continue;
    const auto& v = mesh.state.complex.tet(t).vertex;
    small += dihedral_range(mesh.state.position(v[0]), mesh.state.position(v[1]), mesh.state.position(v[2]),
                            mesh.state.position(v[3]))
                 .smallest < 15.0;
  }
  EXPECT_LT(small, 0.05 * mesh.state.complex.tet_count());
}

TEST(OdtSweep, LeavesFrozenVerticesAndCornersInPlace) {
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.3, 9);
  for (std::size_t v = 0; v < mesh.state.vertices.size(); v += 3) mesh.state.vertices[v].frozen = true;
  const std::vector<Vertex> before = mesh.state.vertices;
  RunControl control;
  odt_sweep(mesh.state, 1.0, control);
  int moved = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    const bool stayed = mesh.state.vertices[v].position == before[v].position;
    moved += !stayed;
    if (before[v].frozen || before[v].carrier.dimension == 0) {
      EXPECT_TRUE(stayed) << "vertex " << v;
    }
  }
  EXPECT_GT(moved, 30);
}

}  // namespace
}  // namespace fgmesh
