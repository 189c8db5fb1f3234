// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "box_grid.hpp"
#include "core/error.hpp"
#include "domain/brep_domain.hpp"

namespace fgmesh {
namespace {

/// The surface of a cube, its twelve edges as curves of one segment each.
SampledBoundary cube() {
  const TetMesh mesh = test::box_grid(2.0, 1);
  SampledBoundary samples;
  samples.points = mesh.points;
  for (const auto& [a, b, c] : mesh.triangles) samples.triangles.push_back({a, b, c});
  samples.triangle_face.assign(mesh.triangle_faces.begin(), mesh.triangle_faces.end());
  samples.triangle_solids.assign(samples.triangles.size(), {1, 0});
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    SampledBoundary::Curve curve;
    curve.edge = mesh.edge_edges[e];
    curve.points = {mesh.edges[e][0], mesh.edges[e][1]};
    samples.curves.push_back(curve);
  }
  return samples;
}

TEST(BrepDomain, HoldsTheSurfaceAndEveryCurve) {
  const SampledBoundary samples = cube();
  ASSERT_EQ(samples.curves.size(), 12u);
  const BrepDomain domain = make_brep_domain(samples);
  EXPECT_EQ(domain.surface->size_of_vertices(), 8u);
  EXPECT_EQ(domain.surface->size_of_facets(), 12u);
  EXPECT_TRUE(domain.surface->is_closed());
  std::multiset<int> curves(domain.curve_of_index.begin(), domain.curve_of_index.end());
  for (int curve = 0; curve < 12; ++curve) EXPECT_EQ(curves.count(curve), 1u);
}

TEST(BrepDomain, KnowsInsideFromOutside) {
  const BrepDomain domain = make_brep_domain(cube());
  const auto is_in_domain = domain.domain->is_in_domain_object();
  EXPECT_TRUE(is_in_domain(to_cgal(Vec3(1.0, 1.1, 0.9))));
  EXPECT_FALSE(is_in_domain(to_cgal(Vec3(3.0, 1.1, 0.9))));
}

TEST(BrepDomain, RefusesAnOpenSurface) {
  SampledBoundary samples = cube();
  samples.triangles.pop_back();
  EXPECT_THROW(make_brep_domain(samples), GeometryError);
}

TEST(BrepDomain, RefusesThreeTrianglesAtAnEdge) {
  SampledBoundary samples = cube();
  const auto [a, b, c] = samples.triangles.front();
  samples.points.push_back(Vec3(5, 5, 5));
  samples.triangles.push_back({a, b, static_cast<int>(samples.points.size()) - 1});
  EXPECT_THROW(make_brep_domain(samples), GeometryError);
}

TEST(BrepDomain, RefusesATriangleThatLooksInward) {
  SampledBoundary samples = cube();
  std::swap(samples.triangles.front()[0], samples.triangles.front()[1]);
  EXPECT_THROW(make_brep_domain(samples), GeometryError);
}

}  // namespace
}  // namespace fgmesh
