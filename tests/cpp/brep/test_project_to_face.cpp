// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFill.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>
#include <random>
#include <thread>

#include "brep_shapes.hpp"

namespace fgmesh {
namespace {

using test::sampled;

/// Points around the origin, at random but the same in each run.
std::vector<Vec3> random_points(int count, double reach) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> coordinate(-reach, reach);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(coordinate(generator), coordinate(generator), coordinate(generator));
  }
  return points;
}

void expect_on_ball(const TopoDS_Shape& ball) {
  const BrepModel model = sampled(ball).first;
  for (const Vec3& p : random_points(500, 80.0)) {
    const SurfacePoint found = model.project_to_face(1, p);
    ASSERT_LT((found.position - 50.0 * p.normalized()).norm(), 1e-7);
    ASSERT_LT((found.normal - p.normalized()).norm(), 1e-6);
  }
}

TEST(ProjectToFace, BallInClosedForm) { expect_on_ball(BRepPrimAPI_MakeSphere(50).Shape()); }

TEST(ProjectToFace, BallAsSplines) {
  expect_on_ball(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeSphere(50).Shape()).Shape());
}

TEST(ProjectToFace, PolesOfABall) {
  for (const bool splines : {false, true}) {
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(50).Shape();
    const BrepModel model = sampled(splines ? BRepBuilderAPI_NurbsConvert(ball).Shape() : ball).first;
    for (const double z : {-70.0, -50.0, 30.0, 50.0, 60.0}) {
      const Vec3 pole(0, 0, z > 0 ? 50 : -50);
      const SurfacePoint found = model.project_to_face(1, Vec3(0, 0, z));
      EXPECT_LT((found.position - pole).norm(), 1e-7);
      EXPECT_TRUE(found.normal.isZero() || (found.normal - pole / 50.0).norm() < 1e-6);
    }
  }
}

void expect_on_torus(const TopoDS_Shape& torus) {
  const BrepModel model = sampled(torus).first;
  for (const Vec3& p : random_points(500, 45.0)) {
    const Vec3 ring = 30.0 * Vec3(p.x(), p.y(), 0.0).normalized();
    if ((p - ring).norm() < 0.5) continue;  // every point of the small circle is about as near
    const Vec3 outward = (p - ring).normalized();
    const SurfacePoint found = model.project_to_face(1, p);
    ASSERT_LT((found.position - (ring + 8.0 * outward)).norm(), 1e-7);
    ASSERT_LT((found.normal - outward).norm(), 1e-6);
  }
}

TEST(ProjectToFace, TorusInClosedForm) { expect_on_torus(BRepPrimAPI_MakeTorus(30, 8).Shape()); }

TEST(ProjectToFace, TorusAsSplines) {
  expect_on_torus(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(30, 8).Shape()).Shape());
}

constexpr double kTurns = 2.5, kPitch = 4.0, kBand = 1.0;

/// The band on a cylinder about z that winds upwards as a thread does, and its four edges.
TopoDS_Face helical_band(double radius, std::array<TopoDS_Edge, 4>& edges) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), radius);
  const double u = 2.0 * M_PI * kTurns, v = kPitch * kTurns;
  const std::array<gp_Pnt2d, 4> corners = {gp_Pnt2d{0, 0}, {u, v}, {u, v + kBand}, {0, kBand}};
  BRepBuilderAPI_MakeWire wire;
  for (int i = 0; i < 4; ++i) {
    wire.Add(BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(corners[i], corners[(i + 1) % 4]).Value(), cylinder));
    edges[i] = wire.Edge();
  }
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(cylinder, wire.Wire());
  BRepLib::BuildCurves3d(face, 1e-7);
  return face;
}

TEST(ProjectToFace, FaceThatWindsAboutItsCylinderMoreThanOnce) {
  constexpr double kInner = 9.0, kOuter = 10.0;
  std::array<TopoDS_Edge, 4> inner, outer;
  BRepBuilderAPI_Sewing sewing(1e-5);
  sewing.Add(helical_band(kInner, inner));
  sewing.Add(helical_band(kOuter, outer));
  for (int i = 0; i < 4; ++i) sewing.Add(BRepFill::Face(inner[i], outer[i]));
  sewing.Perform();
  TopoDS_Solid solid =
      BRepBuilderAPI_MakeSolid(TopoDS::Shell(TopExp_Explorer(sewing.SewedShape(), TopAbs_SHELL).Current()));
  BRepLib::OrientClosedSolid(solid);
  const BrepModel model = sampled(solid).first;
  for (double turn = 0.05; turn < kTurns; turn += 0.1) {
    for (double radius : {kInner, kOuter}) {
      const Vec3 outward(std::cos(2.0 * M_PI * turn), std::sin(2.0 * M_PI * turn), 0.0);
      const Vec3 middle = radius * outward + Vec3(0.0, 0.0, kPitch * turn + 0.5 * kBand);
      double nearest = 1.0;
      for (int face = 1; face <= 6; ++face) {
        const Vec3 found = model.project_to_face(face, middle + 0.1 * outward).position;
        nearest = std::min(nearest, (found - middle).norm());
      }
      EXPECT_LT(nearest, 1e-9) << turn << " turns, radius " << radius;
    }
  }
}

/// Closest point of the wall of a cylinder about z, from z = 0 to `height`.
Vec3 closest_on_wall(const Vec3& p, double radius, double height) {
  const Vec3 on_circle = radius * Vec3(p.x(), p.y(), 0.0).normalized();
  return {on_circle.x(), on_circle.y(), std::clamp(p.z(), 0.0, height)};
}

/// Number of the face whose closest point to `p` is `expected`; 0 where none is.
int face_through(const BrepModel& model, const Vec3& p) {
  for (int face = 1; face <= model.face_count(); ++face) {
    if ((model.project_to_face(face, p).position - p).norm() < 1e-9) return face;
  }
  return 0;
}

TEST(ProjectToFace, WallOfACylinderEndsAtItsRims) {
  for (const bool splines : {false, true}) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(20, 60).Shape();
    const BrepModel model = sampled(splines ? BRepBuilderAPI_NurbsConvert(cylinder).Shape() : cylinder).first;
    const int wall = face_through(model, Vec3(0, 20, 30));
    ASSERT_GT(wall, 0);
    for (const Vec3& p : random_points(500, 90.0)) {
      ASSERT_LT((model.project_to_face(wall, p).position - closest_on_wall(p, 20, 60)).norm(), 1e-7);
    }
  }
}

TEST(ProjectToFace, CrossesTheSeamFromAGuess) {
  const BrepModel model =
      sampled(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(20, 60).Shape()).Shape()).first;
  const int wall = face_through(model, Vec3(0, 20, 30));
  const SurfacePoint start = model.project_to_face(wall, Vec3(20 * std::cos(0.1), 20 * std::sin(0.1), 30));
  const double guess[2] = {start.u, start.v};
  const Vec3 beyond(20 * std::cos(-0.1), 20 * std::sin(-0.1), 30);
  EXPECT_LT((model.project_to_face(wall, beyond, guess).position - beyond).norm(), 1e-7);
}

TEST(ProjectToFace, ConeBeyondItsTip) {
  const BrepModel model = sampled(BRepPrimAPI_MakeCone(10, 0, 25).Shape()).first;
  const int wall = face_through(model, Vec3(0, 0, 25));
  EXPECT_LT((model.project_to_face(wall, Vec3(0.1, 0, 40)).position - Vec3(0, 0, 25)).norm(), 1e-7);
  // Far beside the axis but above the tip, the wall below is still the closest.
  const Vec3 along = Vec3(10, 0, -25).normalized(), p(40, 0, 27);
  const Vec3 tip(0, 0, 25);
  const Vec3 expected = tip + (p - tip).dot(along) * along;
  EXPECT_LT((model.project_to_face(wall, p).position - expected).norm(), 1e-7);
}

TEST(ProjectToFace, StaysOffTheHoleInAPlane) {
  const BrepModel model = sampled(test::box_with_hole()).first;
  const int top = face_through(model, Vec3(-20, 10, 15));
  ASSERT_GT(top, 0);
  for (const Vec3& offset : random_points(300, 7.0)) {
    const Vec3 p = Vec3(15, 0, 15) + offset;
    const Vec3 radial(offset.x(), offset.y(), 0.0);
    const bool over_hole = radial.norm() < 8.0;
    const Vec3 rim = Vec3(15, 0, 15) + 8.0 * radial.normalized();
    const Vec3 expected = over_hole ? rim : Vec3(p.x(), p.y(), 15.0);
    const SurfacePoint found = model.project_to_face(top, p);
    ASSERT_LT((found.position - expected).norm(), 1e-7);
    ASSERT_LT((found.normal - Vec3(0, 0, 1)).norm(), 1e-9);
  }
}

TEST(ProjectToFace, BorderOfACurvedTrimIsExact) {
  // Just inside and just outside of the hole's rim, closer than the chords of its samples.
  const BrepModel model = sampled(test::box_with_hole()).first;
  const int top = face_through(model, Vec3(-20, 10, 15));
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.0317 * i;
    const Vec3 radial(std::cos(angle), std::sin(angle), 0.0), centre(15, 0, 15);
    const Vec3 on_face = centre + 8.0001 * radial, in_hole = centre + 7.9999 * radial;
    EXPECT_LT((model.project_to_face(top, on_face).position - on_face).norm(), 1e-9);
    EXPECT_LT((model.project_to_face(top, in_hole).position - (centre + 8.0 * radial)).norm(), 1e-7);
  }
}

TEST(ProjectToFace, NormalsOfAHolePointToItsAxis) {
  const BrepModel model = sampled(test::box_with_hole()).first;
  const int wall = face_through(model, Vec3(15, 8, 0));
  ASSERT_GT(wall, 0);
  EXPECT_LT((model.project_to_face(wall, Vec3(15, 9, 3)).normal - Vec3(0, -1, 0)).norm(), 1e-9);
}

TEST(ProjectToFace, GuessAndSearchAgreeOnSplines) {
  const auto [model, boundary] = sampled(test::spline_prism());
  for (std::size_t i = 0; i < boundary.triangles.size(); i += 5) {
    const auto& [a, b, c] = boundary.triangles[i];
    const Vec3 middle = (boundary.points[a] + boundary.points[b] + boundary.points[c]) / 3.0;
    const int face = boundary.triangle_face[i];
    const SurfacePoint found = model.project_to_face(face, middle);
    const Vec3 p = found.position + 0.5 * found.normal;
    const double guess[2] = {found.u, found.v};
    // Off a smooth face along its normal, the foot of the perpendicular is where it started.
    ASSERT_LT((model.project_to_face(face, p).position - found.position).norm(), 1e-7);
    ASSERT_LT((model.project_to_face(face, p, guess).position - found.position).norm(), 1e-7);
  }
}

TEST(ProjectToFace, FindsTheNearWallOnBothSidesOfASharpSeam) {
  const auto [model, boundary] = sampled(test::teardrop());
  const int wall = face_through(model, Vec3(22.5, 0, 4));
  ASSERT_GT(wall, 0);
  for (int i = 1; i < 200; ++i) {
    const double t = i / 200.0, s = 1.0 - t;
    const Vec3 on_wall(90.0 * t * s, 30.0 * t * s * (s - t), 4.0);
    const Vec3 along(90.0 * (s - t), 30.0 * ((s - t) * (s - t) - 2.0 * t * s), 0.0);
    const Vec3 aside = Vec3(along.y(), -along.x(), 0.0).normalized();
    // Far less than the wall is thick there, on either side.
    for (const double part : {-0.1, 0.1}) {
      const Vec3 p = on_wall + part * std::min(1.0, 30.0 * t * s) * aside;
      const SurfacePoint found = model.project_to_face(wall, p);
      ASSERT_LT((found.position - on_wall).norm(), 1e-7) << "t = " << t;
      ASSERT_NEAR(std::abs(found.normal.dot(aside)), 1.0, 1e-7) << "t = " << t;
    }
  }
}

TEST(ProjectToFace, IsTheSameFromManyThreads) {
  const auto sample = sampled(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(30, 8).Shape()).Shape());
  const BrepModel& model = sample.first;
  const std::vector<Vec3> points = random_points(2000, 45.0);
  std::vector<Vec3> alone;
  for (const Vec3& p : points) alone.push_back(model.project_to_face(1, p).position);
  std::vector<int> differences(4, 0);
  std::vector<std::thread> threads;
  for (int& count : differences) {
    threads.emplace_back([&] {
      for (std::size_t i = 0; i < points.size(); ++i) {
        count += model.project_to_face(1, points[i]).position != alone[i];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(differences, std::vector<int>(4, 0));
}

TEST(ProjectToFace, UnknownFaceIsAnError) {
  const BrepModel model = sampled(test::box(1, 1, 1)).first;
  EXPECT_THROW(model.project_to_face(0, Vec3::Zero()), std::out_of_range);
  EXPECT_THROW(model.project_to_face(7, Vec3::Zero()), std::out_of_range);
}

}  // namespace
}  // namespace fgmesh
