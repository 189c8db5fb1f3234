// SPDX-License-Identifier: GPL-3.0-or-later
// The third stage on solids in closed form. Lengths in mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "mesh/geometry_refinement.hpp"
#include "mesh/laplacian_smoothing.hpp"
#include "mesh/steiner_points.hpp"
#include "refined_part.hpp"

namespace fgmesh {
namespace {

const test::FunctionField kField = test::linear(Vec3(0.02, 0.01, 0.0), 0.5);
constexpr double kThreshold = 0.1;

void refine(test::RefinedPart& part, double deviation) {
  GeometryRefinementOptions options;
  options.deviation = deviation;
  refine_geometry(part.state, options, part.control);
}

class GeometryRefinement : public testing::TestWithParam<double> {
 protected:
  /// Checks what holds of every part; `off(face, p)` is how far p is from a face.
  template <class Distance>
  void check(const test::AnalyticSolid& solid, Distance off) {
    const double deviation = GetParam();
    test::RefinedPart part(solid, kField, kThreshold);
    part.refine();
    const double error_before = std::abs(test::volume_of(part.state) - solid.volume());
    refine(part, deviation);
    EXPECT_EQ(test::find_fault(part.state, solid, 0.026), "");
    EXPECT_LE(test::largest_variation(part.state), kThreshold);
    const TetMesh mesh = part.state.to_tet_mesh();
    double farthest = 0.0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
      const auto& [a, b, c] = mesh.triangles[f];
      const Vec3 centre = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0;
      farthest = std::max(farthest, off(mesh.triangle_faces[f], centre));
    }
    EXPECT_LE(farthest, deviation);
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const Vec3 middle = 0.5 * (mesh.points[mesh.edges[e][0]] + mesh.points[mesh.edges[e][1]]);
      const Vec3 nearest = solid.project_to_edge(mesh.edge_edges[e], middle).position;
      EXPECT_LE((middle - nearest).norm(), deviation);
    }
    EXPECT_LE(std::abs(test::volume_of(part.state) - solid.volume()), error_before);
    const AngleRange angles = test::angle_range(part.state);
    EXPECT_GE(angles.smallest, 10.0);
    EXPECT_LE(angles.largest, 164.0);
  }
};

TEST_P(GeometryRefinement, OfABall) {
  check(test::BallSolid(10.0), [](int, const Vec3& p) { return std::abs(p.norm() - 10.0); });
}

TEST_P(GeometryRefinement, OfACylinder) {
  check(test::CylinderSolid(10.0, 20.0), [](int face, const Vec3& p) {
    if (face == 1) return std::abs(std::hypot(p.x(), p.y()) - 10.0);
    return std::abs(p.z() - (face == 3 ? 20.0 : 0.0));
  });
}

INSTANTIATE_TEST_SUITE_P(Deviation, GeometryRefinement, testing::Values(0.2, 0.03),
                         [](const auto& info) { return "N" + std::to_string(info.index); });

TEST(GeometryRefinementOfABox, AddsNothingToFlatFaces) {
  const test::BoxSolid box({Vec3::Zero(), Vec3(18, 12, 10)});
  test::RefinedPart part(box, kField, kThreshold);
  part.refine();
  const int before = test::vertex_count(part.state);
  refine(part, 0.01);
  EXPECT_EQ(test::vertex_count(part.state), before);
  EXPECT_EQ(test::find_fault(part.state, box), "");
}

TEST(GeometryRefinementOfStretchedElements, NeedsNoMoreThanThatOfIsotropicOnes) {
  const test::CylinderSolid cylinder(10.0, 20.0);
  const test::FunctionField along = test::linear(Vec3(0.0, 0.0, 0.05));
  std::array<int, 2> tets{};
  for (int stretched : {0, 1}) {
    test::RefinedPart part(cylinder, along, kThreshold);
    const double anisotropy = stretched ? 3.0 : 1.0;
    part.refine(anisotropy);
    GeometryRefinementOptions options;
    options.deviation = 0.03;
    options.goal = quality_goal(anisotropy);
    refine_geometry(part.state, options, part.control);
    EXPECT_EQ(test::find_fault(part.state, cylinder, 0.026), "");
    EXPECT_LE(test::largest_variation(part.state), kThreshold);
    EXPECT_GE(test::angle_range(part.state).smallest, 8.0);
    tets[stretched] = part.state.complex.tet_count();
  }
  EXPECT_LT(tets[1], tets[0]);
}

TEST(FacetDeviation, IsTheDistanceOfTheCentreToTheTrueFace) {
  const test::BallSolid ball(10.0);
  const test::RefinedPart part(ball, kField, kThreshold);
  const TetComplex& complex = part.state.complex;
  int facets = 0;
  for (int t = 0; t < complex.slots(); ++t) {
    for (int face = 0; face < 4 && complex.tet(t).alive(); ++face) {
      if (!complex.tet(t).label[face]) continue;
      Vec3 sum = Vec3::Zero();
      for (int i = 0; i < 4; ++i)
        if (i != face) sum += part.state.position(complex.tet(t).vertex[i]);
      EXPECT_NEAR(facet_deviation(part.state, t, face), 10.0 - (sum / 3.0).norm(), 1e-12);
      ++facets;
    }
  }
  EXPECT_GT(facets, 50);
}

TEST(LaplacianSweep, LeavesFrozenVerticesAndKeepsTheThreshold) {
  test::GridMesh mesh(2.0, 5, test::linear(Vec3(0.22, 0, 0)), 0.1);
  mesh.shake(0.3, 3);
  for (std::size_t v = 0; v < mesh.state.vertices.size(); v += 3) mesh.state.vertices[v].frozen = true;
  const std::vector<Vertex> before = mesh.state.vertices;
  const int above = count_above(mesh.state, 0.1);
  ASSERT_GT(above, 0);
  const TetScore shape(mesh.state, {15.0, 157.0, false});
  RunControl control;
  int moved = 0;
  for (int sweep = 0; sweep < 3; ++sweep) laplacian_sweep(mesh.state, shape, 0.3, control);
  for (std::size_t v = 0; v < before.size(); ++v) {
    const bool stayed = mesh.state.vertices[v].position == before[v].position;
    moved += !stayed;
    if (before[v].frozen || before[v].carrier.dimension == 0) {
      EXPECT_TRUE(stayed) << "vertex " << v;
    }
  }
  EXPECT_GT(moved, 30);
  EXPECT_LE(count_above(mesh.state, 0.1), above);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
}

}  // namespace
}  // namespace fgmesh
