// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include <algorithm>
#include <cmath>

#include "brep_shapes.hpp"

namespace fgmesh {
namespace {

using test::sampled;

TEST(ProjectToEdge, LineIsClampedToItsEnds) {
  const auto [model, boundary] = sampled(test::box(10, 20, 30));
  const auto along_z = std::find_if(
      boundary.curves.begin(), boundary.curves.end(), [&points = boundary.points](const auto& curve) {
        const Vec3 a = points[curve.points.front()], b = points[curve.points.back()];
        return a.head<2>().isZero(1e-9) && b.head<2>().isZero(1e-9);
      });
  ASSERT_NE(along_z, boundary.curves.end());
  EXPECT_LT((model.project_to_edge(along_z->edge, {3, 4, 12}).position - Vec3(0, 0, 12)).norm(), 1e-9);
  EXPECT_LT((model.project_to_edge(along_z->edge, {3, 4, -9}).position - Vec3(0, 0, 0)).norm(), 1e-9);
  EXPECT_LT((model.project_to_edge(along_z->edge, {3, 4, 99}).position - Vec3(0, 0, 30)).norm(), 1e-9);
  EXPECT_NEAR(std::abs(model.project_to_edge(along_z->edge, {3, 4, 12}).tangent.z()), 1.0, 1e-12);
}

TEST(ProjectToEdge, CircleHasNoEnd) {
  const auto [model, boundary] = sampled(BRepPrimAPI_MakeCylinder(20, 60).Shape());
  ASSERT_EQ(boundary.curves.size(), 2u);
  for (const auto& curve : boundary.curves) {
    const double z = boundary.points[curve.points.front()].z();
    for (int i = -20; i <= 20; ++i) {
      const Vec3 radial(std::cos(0.3 * i), std::sin(0.3 * i), 0.0);
      const CurvePoint found = model.project_to_edge(curve.edge, 13.0 * radial + Vec3(0, 0, 5));
      EXPECT_LT((found.position - (20.0 * radial + Vec3(0, 0, z))).norm(), 1e-9);
      EXPECT_NEAR(found.tangent.dot(radial), 0.0, 1e-9);
    }
  }
}

TEST(ProjectToEdge, FindsTheNearSideOfASharpCornerWhereTheEdgeCloses) {
  const auto [model, boundary] = sampled(test::teardrop());
  const auto rim = std::find_if(
      boundary.curves.begin(), boundary.curves.end(), [&points = boundary.points](const auto& curve) {
        return curve.points.front() == curve.points.back() && points[curve.points[0]].z() < 1.0;
      });
  ASSERT_NE(rim, boundary.curves.end());
  for (int i = 1; i < 200; ++i) {
    const double t = i / 200.0, s = 1.0 - t;
    const Vec3 on_edge(90.0 * t * s, 30.0 * t * s * (s - t), 0.0);
    const Vec3 off = on_edge + Vec3(0, 0, 0.7 * t * s);
    ASSERT_LT((model.project_to_edge(rim->edge, off).position - on_edge).norm(), 1e-7) << "t = " << t;
  }
}

TEST(ProjectToEdge, FootOnASplineIsPerpendicular) {
  const auto [model, boundary] = sampled(test::spline_prism());
  ASSERT_EQ(boundary.curves.size(), 2u) << "the seam is smooth, so no curve";
  const auto& curve = boundary.curves[0];
  for (int i = 0; i < 360; ++i) {
    const double angle = i * M_PI / 180.0;
    const Vec3 p = 10.5 * Vec3(std::cos(angle), std::sin(angle), 0.0) +
                   boundary.points[curve.points[0]].z() * Vec3::UnitZ();
    const CurvePoint found = model.project_to_edge(curve.edge, p);
    const Vec3 gap = found.position - p;
    EXPECT_LT(std::abs(gap.dot(found.tangent)), 1e-7);
    double nearest_sample = 1e300;
    for (const int point : curve.points)
      nearest_sample = std::min(nearest_sample, (boundary.points[point] - p).norm());
    EXPECT_LE(gap.norm(), nearest_sample + 1e-9);
    EXPECT_LT((model.project_to_edge(curve.edge, p, &found.t).position - found.position).norm(), 1e-8);
  }
}

TEST(ProjectToEdge, SamplesHaveTheirParameters) {
  const auto [model, boundary] = sampled(test::filleted_box());
  for (const auto& curve : boundary.curves) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const Vec3& p = boundary.points[curve.points[i]];
      const CurvePoint found = model.project_to_edge(curve.edge, p);
      EXPECT_LT((found.position - p).norm(), 1e-7);
      EXPECT_NEAR(found.t, curve.parameters[i], 1e-6);
    }
  }
}

TEST(ProjectToEdge, NoSampleIsCloserThanTheFoot) {
  const auto [model, boundary] = sampled(test::filleted_box());  // lines, and two quarters of a circle
  const Vec3 centre(20, 15, 10);
  for (const auto& curve : boundary.curves) {
    for (int i = 0; i < 26; ++i) {
      const Vec3 p = centre + 40.0 * Vec3(i % 3 - 1, i / 3 % 3 - 1, i / 9 % 3 - 1);
      const CurvePoint found = model.project_to_edge(curve.edge, p);
      EXPECT_GE(found.t, curve.parameters.front() - 1e-9);
      EXPECT_LE(found.t, curve.parameters.back() + 1e-9);
      for (const int point : curve.points) {
        EXPECT_LE((found.position - p).norm(), (boundary.points[point] - p).norm() + 1e-9);
      }
    }
  }
}

TEST(ProjectToEdge, VertexPositionsAreTheCorners) {
  const auto [model, boundary] = sampled(test::box(10, 20, 30));
  for (const auto& corner : boundary.corners) {
    EXPECT_EQ(model.vertex_position(corner.vertex), boundary.points[corner.point]);
  }
}

TEST(Contains, BoxWithHole) {
  const BrepModel model = test::read(test::box_with_hole());
  EXPECT_TRUE(model.contains({0, 0, 0}));
  EXPECT_TRUE(model.contains({-30, 0, 0})) << "on a face";
  EXPECT_TRUE(model.contains({-30, -20, -15})) << "at a corner";
  EXPECT_FALSE(model.contains({15, 0, 0})) << "in the hole";
  EXPECT_FALSE(model.contains({31, 0, 0}));
}

}  // namespace
}  // namespace fgmesh
