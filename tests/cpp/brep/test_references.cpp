// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include <algorithm>
#include <cmath>
#include <functional>

#include "reference_checks.hpp"

namespace fgmesh {
namespace {

using test::gradient_at;
using test::kExact;
using test::meridian;
using test::random_points;
using test::reference;
using test::value_at;

using Distance = std::function<double(const Vec3&)>;

/// Values against a closed form; gradients against the way from the nearest point: a step along the gradient
/// changes the distance by its length.
void expect_distance(const Reference& reference, const std::vector<Vec3>& points, double diagonal,
                     const Distance& truth) {
  std::vector<double> values(points.size()), same(points.size());
  std::vector<Vec3> gradients(points.size());
  reference.distance->evaluate(points.data(), points.size(), values.data());
  reference.distance->evaluate(points.data(), points.size(), same.data(), gradients.data());
  EXPECT_EQ(values, same);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(values[i], truth(points[i]), kExact * diagonal) << Shown{points[i]};
    ASSERT_NEAR(gradients[i].norm(), 1.0, 1e-9) << Shown{points[i]};
    if (std::abs(values[i]) < 1e-3 * diagonal) continue;
    // Towards the nearest point there is no other that could become the nearest.
    const double step = (values[i] > 0.0 ? -1e-3 : 1e-3) * diagonal;
    ASSERT_NEAR(truth(points[i] + step * gradients[i]), values[i] + step, 1e-8 * diagonal)
        << Shown{points[i]} << " gradient " << Shown{gradients[i]};
  }
}

double to_box(const Vec3& p, const Vec3& low, const Vec3& high) {
  return (p - p.cwiseMax(low).cwiseMin(high)).norm();
}

double signed_to_box(const Vec3& p, const Vec3& low, const Vec3& high) {
  const double depth = std::min((p - low).minCoeff(), (high - p).minCoeff());
  return depth > 0.0 ? -depth : to_box(p, low, high);
}

double to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + t * (b - a) - p).norm();
}

TEST(References, FacesOfABox) {
  const TopoDS_Shape box = test::box(10, 20, 30);
  const std::vector<Vec3> points = random_points(2000, 30.0, Vec3(5, 10, 15));
  const Vec3 low = Vec3::Zero(), high(10, 20, 30);
  for (int face = 1; face <= 6; ++face) {  // in OpenCASCADE's order: x = 0, x = 10, y = 0, ...
    const int axis = (face - 1) / 2;
    Vec3 face_low = low, face_high = high;
    (face % 2 == 1 ? face_high : face_low)[axis] = (face % 2 == 1 ? low : high)[axis];
    expect_distance(reference(box, "Face" + std::to_string(face)), points, 37.0,
                    [&](const Vec3& p) { return to_box(p, face_low, face_high); });
  }
}

TEST(References, SolidsHaveASign) {
  const Vec3 high(10, 20, 30);
  expect_distance(reference(test::box(10, 20, 30), "Solid1"), random_points(3000, 30.0, 0.5 * high), 37.0,
                  [&](const Vec3& p) { return signed_to_box(p, Vec3::Zero(), high); });
}

TEST(References, NeighboursMeasureTheirOwnBoundary) {
  const TopoDS_Shape joined = test::two_joined_boxes();
  const std::vector<Vec3> points = random_points(1000, 15.0, Vec3(10, 5, 5));
  const Reference first = reference(joined, "Solid1"), second = reference(joined, "Solid2");
  const bool first_is_low = value_at(first, Vec3(5, 5, 5)) < 0.0;
  const auto low = [](const Vec3& p) { return signed_to_box(p, Vec3::Zero(), Vec3(10, 10, 10)); };
  const auto high = [](const Vec3& p) { return signed_to_box(p, Vec3(10, 0, 0), Vec3(20, 10, 10)); };
  expect_distance(first_is_low ? first : second, points, 24.0, low);
  expect_distance(first_is_low ? second : first, points, 24.0, high);
}

TEST(References, NotchesKeepTheSign) {
  // A corner cut out of a cube: three re-entrant edges and a re-entrant corner.
  const Vec3 notch(4, 5, 6), high(10, 10, 10);
  const TopoDS_Shape cut =
      BRepAlgoAPI_Cut(test::box(10, 10, 10), BRepPrimAPI_MakeBox(gp_Pnt(4, 5, 6), gp_Pnt(10, 10, 10)).Shape())
          .Shape();
  const Reference solid = reference(cut, "Solid1");
  for (const Vec3& p : random_points(5000, 8.0, 0.5 * high)) {
    const bool in_notch = (p.array() > notch.array()).all();
    const bool inside = signed_to_box(p, Vec3::Zero(), high) < 0.0 && !in_notch;
    ASSERT_EQ(value_at(solid, p) < 0.0, inside) << Shown{p};
    if (!inside) continue;
    const double expected =
        std::min({to_box(p, notch, Vec3::Constant(1e3)), p.minCoeff(), (high - p).minCoeff()});
    ASSERT_NEAR(value_at(solid, p), -expected, kExact * 17.0) << Shown{p};
  }
}

TEST(References, BodiesOfRevolution) {
  const auto cylinder = [](const Vec3& p) {
    const Eigen::Vector2d q = meridian(p);
    const double inside = std::min({20.0 - q.x(), q.y(), 60.0 - q.y()});
    return inside > 0.0 ? -inside
                        : std::hypot(std::max(q.x() - 20.0, 0.0), q.y() - std::clamp(q.y(), 0.0, 60.0));
  };
  const auto ball = [](const Vec3& p) { return p.norm() - 50.0; };
  const auto torus = [](const Vec3& p) {
    const Eigen::Vector2d q = meridian(p);
    return std::hypot(q.x() - 30.0, q.y()) - 8.0;
  };
  const auto cone = [](const Vec3& p) {
    const Eigen::Vector2d q = meridian(p), base(10, 0), tip(0, 25);
    const double distance = std::min(to_segment(q, base, tip), to_segment(q, {0, 0}, base));
    const bool inside = q.y() > 0.0 && q.x() / 10.0 + q.y() / 25.0 < 1.0;
    return inside ? -distance : distance;
  };
  const struct {
    TopoDS_Shape shape;
    double reach;
    Distance truth;
  } bodies[] = {{BRepPrimAPI_MakeCylinder(20, 60).Shape(), 70.0, cylinder},
                {BRepPrimAPI_MakeSphere(50).Shape(), 70.0, ball},
                {BRepPrimAPI_MakeTorus(30, 8).Shape(), 45.0, torus},
                {BRepPrimAPI_MakeCone(10, 0, 25).Shape(), 30.0, cone}};
  for (const auto& body : bodies) {
    const std::vector<Vec3> points = random_points(1500, body.reach);
    expect_distance(reference(body.shape, "Solid1"), points, body.reach, body.truth);
    const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(body.shape).Shape();
    expect_distance(reference(splines, "Solid1"), points, body.reach, body.truth);
  }
}

void expect_box_with_hole(const TopoDS_Shape& part) {
  const Vec3 low(-30, -20, -15), high(30, 20, 15);
  const auto to_axis = [](const Vec3& p) { return std::hypot(p.x() - 15.0, p.y()); };
  const auto solid = [&](const Vec3& p) {
    const double in_box = signed_to_box(p, low, high), from_wall = to_axis(p) - 8.0;
    return std::max(in_box, -from_wall);
  };
  std::vector<Vec3> inside;
  for (const Vec3& p : random_points(6000, 30.0)) {
    if (solid(p) < 0.0) inside.push_back(p);
  }
  ASSERT_GT(inside.size(), 500u);
  expect_distance(reference(part, "Solid1"), inside, 78.0, solid);

  int top = 0;
  for (int face = 1; face <= 7; ++face) {
    const Reference candidate = reference(part, "Face" + std::to_string(face));
    if (std::abs(value_at(candidate, Vec3(-20, 10, 15))) < 1e-9) top = face;
  }
  ASSERT_GT(top, 0);
  expect_distance(reference(part, "Face" + std::to_string(top)), random_points(3000, 35.0), 78.0,
                  [&](const Vec3& p) {
                    const double beside = std::max(8.0 - to_axis(p), 0.0);
                    return beside > 0.0 ? std::hypot(beside, p.z() - 15.0)
                                        : to_box(p, Vec3(-30, -20, 15), Vec3(30, 20, 15));
                  });
}

TEST(References, HolesBelongToNoFace) { expect_box_with_hole(test::box_with_hole()); }

TEST(References, HolesBelongToNoSpline) {
  expect_box_with_hole(BRepBuilderAPI_NurbsConvert(test::box_with_hole()).Shape());
}

TEST(References, DrilledTips) {
  // A block less a cone whose tip points down: inside, below the tip, the tip is the nearest point.
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(-30, -30, -30), gp_Pnt(30, 30, 20)).Shape();
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0, 20, 20).Shape();
  const TopoDS_Shape part = BRepAlgoAPI_Cut(block, drill).Shape();
  for (const TopoDS_Shape& shape : {part, BRepBuilderAPI_NurbsConvert(part).Shape()}) {
    const Reference solid = reference(shape, "Solid1");
    EXPECT_NEAR(value_at(solid, Vec3(0, 0, -7)), -7.0, 1e-7);
    EXPECT_NEAR(value_at(solid, Vec3(1, 2, -7)), -Vec3(1, 2, -7).norm(), 1e-7);
    EXPECT_LT((gradient_at(solid, Vec3(0, 0, -7)) - Vec3(0, 0, 1)).norm(), 1e-7);
    EXPECT_NEAR(value_at(solid, Vec3(0, 0, 8)), 8.0 * std::sqrt(0.5), 1e-7);
  }
}

TEST(References, EdgesAndVertices) {
  const TopoDS_Shape box = test::box(10, 20, 30);
  const std::vector<Vec3> points = random_points(500, 30.0, Vec3(5, 10, 15));
  const BrepModel model = test::sampled(box).first;
  for (int vertex = 1; vertex <= 8; ++vertex) {
    const Vec3 corner = model.vertex_position(vertex);
    expect_distance(reference(box, "Vertex" + std::to_string(vertex)), points, 37.0,
                    [&](const Vec3& p) { return (p - corner).norm(); });
  }
  for (int edge = 1; edge <= 12; ++edge) {
    const Vec3 a = model.project_to_edge(edge, Vec3(-99, -99, -99)).position;
    const Vec3 b = model.project_to_edge(edge, Vec3(99, 99, 99)).position;
    expect_distance(reference(box, "Edge" + std::to_string(edge)), points, 37.0,
                    [&](const Vec3& p) { return to_box(p, a, b); });
  }
  int circles = 0;
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(20, 60).Shape();
  for (int edge = 1; edge <= 3; ++edge) {
    const Reference candidate = reference(cylinder, "Edge" + std::to_string(edge));
    for (const double z : {0.0, 60.0}) {
      if (std::abs(value_at(candidate, Vec3(0, -20, z))) > 1e-9) continue;
      ++circles;
      expect_distance(candidate, random_points(500, 60.0), 80.0,
                      [&](const Vec3& p) { return std::hypot(meridian(p).x() - 20.0, p.z() - z); });
    }
  }
  EXPECT_EQ(circles, 2);
}

}  // namespace
}  // namespace fgmesh
