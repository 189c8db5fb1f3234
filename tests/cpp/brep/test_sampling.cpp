// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "brep_shapes.hpp"
#include "core/error.hpp"

namespace fgmesh {
namespace {

using test::sampled;

double enclosed_volume(const SampledBoundary& boundary) {
  double volume = 0.0;
  for (const auto& [a, b, c] : boundary.triangles) {
    volume += boundary.points[a].dot(boundary.points[b].cross(boundary.points[c])) / 6.0;
  }
  return volume;
}

class KnownSolidSampling : public testing::TestWithParam<test::KnownSolid> {};

TEST_P(KnownSolidSampling, IsAClosedManifold) {
  const SampledBoundary boundary = sampled(GetParam().shape).second;
  std::map<std::pair<int, int>, int> directed;
  std::set<int> used;
  for (const auto& t : boundary.triangles) {
    for (int k = 0; k < 3; ++k) {
      ++directed[{t[k], t[(k + 1) % 3]}];
      used.insert(t[k]);
    }
  }
  for (const auto& [edge, count] : directed) {
    ASSERT_EQ(count, 1);
    ASSERT_EQ(directed.count({edge.second, edge.first}), 1u);
  }
  EXPECT_EQ(used.size(), boundary.points.size()) << "stray points";
  const int points = static_cast<int>(boundary.points.size()),
            triangles = static_cast<int>(boundary.triangles.size());
  EXPECT_EQ(points - static_cast<int>(directed.size()) / 2 + triangles, GetParam().euler);
}

TEST_P(KnownSolidSampling, HasTheVolumeOutward) {
  const SampledBoundary boundary = sampled(GetParam().shape).second;
  EXPECT_NEAR(boundary.volume, GetParam().volume, 1e-6 * GetParam().volume);
  EXPECT_NEAR(enclosed_volume(boundary), GetParam().volume, 3e-3 * GetParam().volume);
}

TEST_P(KnownSolidSampling, HasNoFlatTriangle) {
  const SampledBoundary boundary = sampled(GetParam().shape).second;
  for (const auto& [a, b, c] : boundary.triangles) {
    const Vec3 ab = boundary.points[b] - boundary.points[a], ac = boundary.points[c] - boundary.points[a];
    ASSERT_GT(ab.cross(ac).norm(), 1e-8 * std::max(ab.squaredNorm(), ac.squaredNorm()));
  }
}

TEST_P(KnownSolidSampling, LiesOnTheTrueFaces) {
  const SampledBoundary boundary = sampled(GetParam().shape).second;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(GetParam().shape, TopAbs_FACE, faces);
  const std::size_t stride = boundary.triangles.size() / 60 + 1;
  for (std::size_t i = 0; i < boundary.triangles.size(); i += stride) {
    for (const int point : boundary.triangles[i]) {
      const Vec3& p = boundary.points[point];
      const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Shape();
      const BRepExtrema_DistShapeShape distance(vertex, faces(boundary.triangle_face[i]));
      ASSERT_LT(distance.Value(), 1e-7) << "Face" << boundary.triangle_face[i];
    }
  }
}

TEST_P(KnownSolidSampling, BoundsFitTightly) {
  const SampledBoundary boundary = sampled(GetParam().shape).second;
  Vec3 low = boundary.points.front(), high = low;
  for (const Vec3& p : boundary.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double deflection = boundary.bounds.diagonal() / 2000.0;
  EXPECT_LT((low - boundary.bounds.low).cwiseAbs().maxCoeff(), 2.0 * deflection);
  EXPECT_LT((high - boundary.bounds.high).cwiseAbs().maxCoeff(), 2.0 * deflection);
}

std::string test_name(const testing::TestParamInfo<test::KnownSolid>& info) {
  std::string name = info.param.name;
  for (char& c : name) c = c == ' ' ? '_' : c;
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, KnownSolidSampling, testing::ValuesIn(test::known_solids()), test_name);

TEST(Sampling, KeepsTheDeflectionOnABallWithinTwofold) {
  SamplingOptions options;
  options.deflection = 0.05;
  const SampledBoundary boundary = sampled(BRepPrimAPI_MakeSphere(50).Shape(), options).second;
  double deepest = 0.0;
  for (const auto& [a, b, c] : boundary.triangles) {
    const Vec3 middle = (boundary.points[a] + boundary.points[b] + boundary.points[c]) / 3.0;
    deepest = std::max(deepest, 50.0 - middle.norm());
  }
  EXPECT_LT(deepest, 2.0 * options.deflection);
  EXPECT_GT(deepest, 0.1 * options.deflection) << "needlessly fine";
}

/// Places of the corners, lowest first.
std::vector<Vec3> corners_of(const SampledBoundary& boundary) {
  std::vector<Vec3> places;
  for (const auto& corner : boundary.corners) places.push_back(boundary.points[corner.point]);
  std::sort(places.begin(), places.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  return places;
}

TEST(Sampling, HasThePolesOfABallAndNoCurves) {
  const SampledBoundary boundary = sampled(BRepPrimAPI_MakeSphere(50).Shape()).second;
  EXPECT_TRUE(boundary.curves.empty());
  const std::vector<Vec3> poles = corners_of(boundary);
  ASSERT_EQ(poles.size(), 2u);
  EXPECT_LT((poles[0] - Vec3(0, 0, -50)).norm(), 1e-9);
  EXPECT_LT((poles[1] - Vec3(0, 0, 50)).norm(), 1e-9);
}

TEST(Sampling, HasTheTipOfAConeAndTheVertexOfItsRim) {
  const SampledBoundary boundary = sampled(BRepPrimAPI_MakeCone(10, 0, 25).Shape()).second;
  const std::vector<Vec3> corners = corners_of(boundary);
  ASSERT_EQ(corners.size(), 2u);
  EXPECT_LT((corners[0] - Vec3(10, 0, 0)).norm(), 1e-9);
  EXPECT_LT((corners[1] - Vec3(0, 0, 25)).norm(), 1e-9);
  ASSERT_EQ(boundary.curves.size(), 1u);
  EXPECT_EQ(boundary.curves[0].points.front(), boundary.curves[0].points.back());
}

TEST(Sampling, FollowsTheTwelveEdgesOfABox) {
  const SampledBoundary boundary = sampled(test::box(10, 20, 30)).second;
  EXPECT_EQ(boundary.curves.size(), 12u);
  EXPECT_EQ(boundary.corners.size(), 8u);
  for (const auto& curve : boundary.curves) {
    EXPECT_EQ(curve.faces.size(), 2u);
    EXPECT_EQ(curve.points.size(), curve.parameters.size());
  }
}

TEST(Sampling, CurvesRunAlongTriangleSides) {
  const SampledBoundary boundary = sampled(test::box_with_hole()).second;
  std::set<std::pair<int, int>> sides;
  for (const auto& t : boundary.triangles) {
    for (int k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
  }
  for (const auto& curve : boundary.curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      EXPECT_TRUE(sides.count({curve.points[i - 1], curve.points[i]}));
    }
  }
}

TEST(Sampling, SharedFaceSeparatesTwoSolids) {
  const SampledBoundary boundary = sampled(test::two_joined_boxes()).second;
  EXPECT_EQ(boundary.solid_count, 2);
  EXPECT_EQ(boundary.face_count, 11);  // twelve, of which two are one
  EXPECT_NEAR(boundary.volume, 2000.0, 1e-6);
  double shared_area = 0.0;
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    if (boundary.triangle_solids[i][1] == 0) continue;
    EXPECT_EQ(boundary.triangle_solids[i], (std::array<int, 2>{1, 2}));
    const auto& [a, b, c] = boundary.triangles[i];
    const Vec3 doubled =
        (boundary.points[b] - boundary.points[a]).cross(boundary.points[c] - boundary.points[a]);
    EXPECT_GT(doubled.x(), 0.0) << "Solid1 lies at smaller x, so its outward normal points to larger";
    shared_area += 0.5 * doubled.norm();
  }
  EXPECT_NEAR(shared_area, 100.0, 1e-9);
}

TEST(Sampling, ThinWallKeepsItsVolume) {
  // A tube 200 across with a wall of 0.1: half the default deflection of its diagonal.
  const TopoDS_Shape tube = test::thin_tube(100.0, 99.9, 20.0);
  const double volume = M_PI * (100.0 * 100.0 - 99.9 * 99.9) * 20.0;
  const SampledBoundary boundary = sampled(tube).second;
  EXPECT_NEAR(boundary.volume, volume, 1e-6 * volume);
  EXPECT_NEAR(enclosed_volume(boundary), volume, 0.002 * volume);
}

TEST(Sampling, IsTheSameTwice) {
  const SampledBoundary first = sampled(test::filleted_box()).second;
  const SampledBoundary second = sampled(test::filleted_box()).second;
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.points, second.points);
}

TEST(Sampling, StopsWhenCancelled) {
  RunControl control;
  BrepModel model = test::read(test::box(10, 20, 30));
  control.cancel();
  EXPECT_THROW(model.sample({}, control), Cancelled);
}

}  // namespace
}  // namespace fgmesh
