// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/error.hpp"
#include "mesh/boundary_recovery.hpp"
#include "mesh/surface_remeshing.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

const test::FunctionField kField = test::constant(0.5);

/// A solid's surface, remeshed.
struct Remeshed {
  Remeshed(const test::AnalyticSolid& solid, double size, double deviation)
      : samples(solid.samples()),
        state(solid, kField, 0.1, samples.bounds.diagonal()),
        surface(state, samples) {
    remesh_surface(surface, WallThickness(samples), {size, deviation, 0.6}, control);
  }

  /// Every edge with the number of its triangles.
  std::map<std::array<int, 2>, int> edges() const {
    std::map<std::array<int, 2>, int> found;
    for (const SurfaceTriangle& triangle : surface.triangles)
      for (int i = 0; i < 3 && triangle.alive(); ++i) {
        const auto [a, b] = std::minmax(triangle.vertex[i], triangle.vertex[(i + 1) % 3]);
        ++found[{a, b}];
      }
    return found;
  }

  SampledBoundary samples;
  RunControl control;
  MeshState state;
  SurfaceMesh surface;
};

TEST(RemeshedSurface, OfABallIsClosedAndEvenlyFine) {
  const test::BallSolid ball(10.0);
  const Remeshed part(ball, 3.0, 1.0);
  for (const auto& [edge, count] : part.edges()) {
    EXPECT_EQ(count, 2);
    const double length = (part.surface.position(edge[0]) - part.surface.position(edge[1])).norm();
    EXPECT_GT(length, 0.35 * 3.0);
    EXPECT_LT(length, 1.6 * 3.0);
  }
  for (const Vertex& vertex : part.surface.vertices) EXPECT_NEAR(vertex.position.norm(), 10.0, 1e-9);
  EXPECT_LT(part.surface.volume(), ball.volume());
  EXPECT_GT(part.surface.volume(), 0.9 * ball.volume());
}

TEST(SurfaceFlip, PartsATriangleThatIsTurnedOverFromItsNeighbour) {
  const test::BoxSolid box({{0, 0, 0}, {10, 10, 10}});
  const auto on_top = [&](const SampledBoundary& all, std::size_t t) {
    return std::all_of(all.triangles[t].begin(), all.triangles[t].end(),
                       [&](int v) { return all.points[v].z() > 9.99; });
  };
  const SampledBoundary all = box.samples();
  std::size_t top = 0;
  while (!on_top(all, top)) ++top;

  SampledBoundary samples;
  samples.bounds = all.bounds;
  samples.points = {{2, 2, 10}, {6, 2, 10}, {4, 6, 10}, {4, 5, 10}};
  samples.triangles = {{0, 1, 2}, {1, 0, 3}};  // the second looks down and lies upon the first
  samples.triangle_face = {all.triangle_face[top], all.triangle_face[top]};
  samples.triangle_solids = {all.triangle_solids[top], all.triangle_solids[top]};
  MeshState state(box, kField, 0.1, samples.bounds.diagonal());
  SurfaceMesh surface(state, samples);
  ASSERT_TRUE(surface.flip(0, 1, 1.0));
  double area = 0.0;
  for (const SurfaceTriangle& triangle : surface.triangles) {
    if (!triangle.alive()) continue;
    const auto& [a, b, c] = triangle.vertex;
    const Vec3 twice = area_vector(surface.position(a), surface.position(b), surface.position(c));
    EXPECT_GT(twice.z(), 0.0);
    area += 0.5 * twice.z();
  }
  EXPECT_NEAR(area, 8.0 - 6.0, 1e-12);
}

TEST(SurfaceUnfold, TakesAwayAVertexThatLiesBeyondTheTrianglesAroundIt) {
  const test::BoxSolid box({{0, 0, 0}, {10, 10, 10}});
  const SampledBoundary all = box.samples();
  SampledBoundary samples;
  samples.bounds = all.bounds;
  // A square on top of the box, and a vertex below its lower side.
  samples.points = {{2, 2, 10}, {8, 2, 10}, {8, 8, 10}, {2, 8, 10}, {5, 1.5, 10}};
  samples.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  for (std::size_t t = 0; t < all.triangles.size() && samples.triangle_face.empty(); ++t) {
    const std::array<int, 3>& v = all.triangles[t];
    if (!std::all_of(v.begin(), v.end(), [&](int i) { return all.points[i].z() > 9.99; })) continue;
    samples.triangle_face.assign(4, all.triangle_face[t]);
    samples.triangle_solids.assign(4, all.triangle_solids[t]);
  }
  MeshState state(box, kField, 0.1, samples.bounds.diagonal());
  SurfaceMesh surface(state, samples);
  for (int corner = 0; corner < 4; ++corner) surface.vertices[corner].carrier = {0, corner + 1};
  ASSERT_FALSE(surface.faces_out(0));
  ASSERT_TRUE(surface.unfold(0));
  EXPECT_TRUE(surface.at(4).empty());
  double area = 0.0;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    if (!surface.triangles[t].alive()) continue;
    EXPECT_TRUE(surface.faces_out(t));
    const auto& [a, b, c] = surface.triangles[t].vertex;
    area += 0.5 * area_vector(surface.position(a), surface.position(b), surface.position(c)).norm();
  }
  EXPECT_NEAR(area, 36.0, 1e-12);
}

TEST(RemeshedSurface, FollowsTheCurvature) {
  // The sagitta of a chord of length h is h^2 / 8R, so that these allow 2.8 and 0.9 mm.
  const test::BallSolid ball(10.0);
  for (const double deviation : {0.1, 0.01}) {
    const Remeshed part(ball, 100.0, deviation);
    double farthest = 0.0;
    for (const auto& [edge, count] : part.edges()) {
      const Vec3 middle = 0.5 * (part.surface.position(edge[0]) + part.surface.position(edge[1]));
      farthest = std::max(farthest, 10.0 - middle.norm());
    }
    EXPECT_LT(farthest, 2.5 * deviation);
    EXPECT_GT(farthest, 0.5 * deviation);
  }
}

TEST(RemeshedSurface, KeepsCreasesAndFaces) {
  const test::CylinderSolid cylinder(5.0, 20.0);
  const Remeshed part(cylinder, 4.0, 0.3);
  std::map<int, double> lengths;
  for (const auto& [key, edge] : part.surface.creases()) {
    const auto [a, b] = SurfaceMesh::ends(key);
    lengths[edge] += (part.surface.position(a) - part.surface.position(b)).norm();
    std::vector<int> around;
    part.surface.at_edge(a, b, around);
    ASSERT_EQ(around.size(), 2u);
    EXPECT_NE(part.surface.triangles[around[0]].face, part.surface.triangles[around[1]].face);
  }
  ASSERT_EQ(lengths.size(), 2u);
  for (const auto& [edge, length] : lengths) EXPECT_NEAR(length, cylinder.edge_length(edge), 0.06 * length);
  std::set<int> faces;
  for (const SurfaceTriangle& triangle : part.surface.triangles)
    if (triangle.alive()) faces.insert(triangle.face);
  EXPECT_EQ(faces, (std::set<int>{1, 2, 3}));
}

TEST(Tetrahedralization, FillsWhatTheSurfaceBounds) {
  for (const double size : {2.0, 6.0}) {
    const test::CylinderSolid cylinder(5.0, 20.0);
    Remeshed part(cylinder, size, 0.3);
    tetrahedralize(part.state, part.surface, part.control);
    const double enclosed = part.surface.volume();
    EXPECT_NEAR(test::volume_of(part.state), enclosed, 1e-9 * enclosed);
    std::set<std::array<int, 3>> wanted, found;
    for (const SurfaceTriangle& triangle : part.surface.triangles) {
      std::array<int, 3> v = triangle.vertex;
      std::sort(v.begin(), v.end());
      if (triangle.alive()) wanted.insert(v);
    }
    for (int t = 0; t < part.state.complex.slots(); ++t) {
      const Tet& tet = part.state.complex.tet(t);
      for (int i = 0; i < 4 && tet.alive(); ++i) {
        EXPECT_EQ(tet.label[i] != 0, tet.neighbour[i] < 0);
        if (!tet.label[i]) continue;
        std::array<int, 3> v = {tet.vertex[kFaceVertices[i][0]], tet.vertex[kFaceVertices[i][1]],
                                tet.vertex[kFaceVertices[i][2]]};
        std::sort(v.begin(), v.end());
        found.insert(v);
      }
    }
    EXPECT_EQ(found, wanted);
  }
}

TEST(Tetrahedralization, RefusesASurfaceThatCutsItself) {
  const test::BoxSolid box({Vec3::Zero(), Vec3::Constant(1.0)});
  const SampledBoundary samples = box.samples();
  MeshState state(box, kField, 0.1, 2.0);
  SurfaceMesh surface(state, samples);
  RunControl control;
  remesh_surface(surface, WallThickness(samples), {1.0, 0.1, 0.6}, control);
  for (int v = 0; v < static_cast<int>(surface.vertices.size()); ++v)
    if (!surface.at(v).empty() && surface.vertices[v].carrier.dimension == 0 &&
        surface.position(v).isZero()) {
      surface.vertices[v].position = Vec3(1.7, 1.6, 1.5);  // beyond the corner opposite
    }
  EXPECT_THROW(tetrahedralize(state, surface, control), GeometryError);
}

}  // namespace
}  // namespace fgmesh
