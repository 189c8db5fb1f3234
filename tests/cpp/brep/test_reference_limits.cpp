// SPDX-License-Identifier: GPL-3.0-or-later
// Distances where they are hard: on medial axes, on the boundary, from threads, to what is not there.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include <algorithm>
#include <cmath>
#include <gp_Elips.hxx>
#include <random>
#include <thread>

#include "core/error.hpp"
#include "reference_checks.hpp"

namespace fgmesh {
namespace {

using test::gradient_at;
using test::kExact;
using test::meridian;
using test::random_points;
using test::reference;
using test::value_at;

/// Distance to the ellipse x = 20 cos t, y = 8 sin t in its plane, by a scan and golden sections about its
/// lowest values: nothing is said of how many minima there are.
double to_ellipse(double x, double y) {
  constexpr int kSteps = 3000;
  const auto distance = [&](double t) { return std::hypot(20.0 * std::cos(t) - x, 8.0 * std::sin(t) - y); };
  std::vector<double> scan(kSteps);
  for (int i = 0; i < kSteps; ++i) scan[i] = distance(2.0 * M_PI * i / kSteps);
  double least = 1e300;
  for (int i = 0; i < kSteps; ++i) {
    if (scan[i] > scan[(i + 1) % kSteps] || scan[i] > scan[(i + kSteps - 1) % kSteps]) continue;
    double low = 2.0 * M_PI * (i - 1) / kSteps, high = 2.0 * M_PI * (i + 1) / kSteps;
    while (high - low > 1e-9) {
      const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
      distance(a) < distance(b) ? high = b : low = a;
    }
    least = std::min(least, distance(0.5 * (low + high)));
  }
  return least;
}

TEST(References, EllipseAboutItsMedialAxis) {
  const gp_Elips ellipse(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 20, 8);
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge()).Wire();
  const TopoDS_Shape prism =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire).Face(), gp_Vec(0, 0, 100)).Shape();
  // The medial axis is y = 0, |x| <= 20 - 8 * 8 / 20; its ends are where the two nearest points become one.
  std::vector<Vec3> points;
  std::mt19937 generator(3);
  std::normal_distribution<double> beside(0.0, 1.0);
  for (const double scatter : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 1.0}) {
    for (int i = 0; i < 100; ++i) points.emplace_back(0.2 * i, scatter * beside(generator), 50.0);
    for (int i = 0; i < 100; ++i) {
      points.emplace_back(16.8 + scatter * beside(generator), scatter * beside(generator), 50.0);
    }
  }
  int wall = 0, rim = 0;
  for (int face = 1; face <= 3; ++face) {
    if (value_at(reference(prism, "Face" + std::to_string(face)), Vec3(0, 8, 50)) < 1e-9) wall = face;
  }
  for (int edge = 1; edge <= 3; ++edge) {
    if (value_at(reference(prism, "Edge" + std::to_string(edge)), Vec3(0, 8, 0)) < 1e-9) rim = edge;
  }
  ASSERT_GT(wall, 0);
  ASSERT_GT(rim, 0);
  const Reference to_wall = reference(prism, "Face" + std::to_string(wall));
  const Reference to_rim = reference(prism, "Edge" + std::to_string(rim));
  for (const Vec3& p : points) {
    const double truth = to_ellipse(p.x(), p.y());
    ASSERT_NEAR(value_at(to_wall, p), truth, kExact * 110.0) << Shown{p};
    ASSERT_NEAR(value_at(to_rim, p), std::hypot(truth, 50.0), kExact * 110.0) << Shown{p};
    ASSERT_NEAR(gradient_at(to_wall, p).norm(), 1.0, 1e-9) << Shown{p};
  }
}

TEST(References, DefinedWhereTheGradientIsNot) {
  const Reference ball = reference(BRepPrimAPI_MakeSphere(50).Shape(), "Solid1");
  EXPECT_NEAR(value_at(ball, Vec3::Zero()), -50.0, 1e-7);
  EXPECT_NEAR(gradient_at(ball, Vec3::Zero()).norm(), 1.0, 1e-12);
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(30, 8).Shape();
  for (const char* name : {"Face1", "Solid1"}) {
    const Reference measured = reference(torus, name);
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0, 0, 5), Vec3(30, 0, 0), Vec3(0, -30, 0)}) {
      const double truth = std::hypot(meridian(p).x() - 30.0, p.z()) - 8.0;
      EXPECT_NEAR(value_at(measured, p), measured.is_solid ? truth : std::abs(truth), 1e-9);
      EXPECT_NEAR(gradient_at(measured, p).norm(), 1.0, 1e-12);
    }
  }
  // On the boundary: out of a solid, into the solid from its face, nothing from edges and corners.
  const TopoDS_Shape box = test::box(10, 20, 30);
  const Vec3 on_face(0, 7, 9);
  EXPECT_LT((gradient_at(reference(box, "Solid1"), on_face) - Vec3(-1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((gradient_at(reference(box, "Face1"), on_face) - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(gradient_at(reference(box, "Vertex1"), test::sampled(box).first.vertex_position(1)),
            Vec3::Zero());
  EXPECT_TRUE(gradient_at(reference(box, "Solid1"), Vec3(0, 0, 30)).allFinite());
  // No point: no distance, and no exception.
  EXPECT_TRUE(std::isnan(value_at(ball, Vec3::Constant(std::nan("")))));
}

TEST(References, BoundsHold) {
  const TopoDS_Shape part = test::box_with_hole();
  for (const char* name : {"Solid1", "Face2", "Edge3", "Vertex1"}) {
    const Reference measured = reference(part, name);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> coordinate(-40, 40), share(0, 1);
    for (int i = 0; i < 100; ++i) {
      const Vec3 low(coordinate(generator), coordinate(generator), coordinate(generator));
      const Box box{low, low + 20.0 * Vec3(share(generator), share(generator), share(generator))};
      double least = 0.0, most = 0.0;
      measured.distance->bounds(box, least, most);
      for (int k = 0; k < 20; ++k) {
        const Vec3 at(share(generator), share(generator), share(generator));
        const double value = value_at(measured, low + at.cwiseProduct(box.high - low));
        EXPECT_LE(least, value);
        EXPECT_GE(most, value);
      }
      EXPECT_TRUE(measured.is_solid || least >= 0.0);
    }
  }
}

TEST(References, AreTheSameFromManyThreads) {
  const Reference solid = reference(test::spline_prism(), "Solid1");
  const std::vector<Vec3> points = random_points(1000, 15.0);
  std::vector<std::vector<double>> values(4, std::vector<double>(points.size()));
  std::vector<std::thread> threads;
  for (auto& own : values) {
    threads.emplace_back([&] { solid.distance->evaluate(points.data(), points.size(), own.data()); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& own : values) EXPECT_EQ(own, values.front());
}

TEST(References, LostOnesAreNamed) {
  const TopoDS_Shape box = test::box(10, 20, 30);
  for (const auto& [name, part] :
       {std::pair("Face7", "Face7 is lost: the shape ends with Face6"), std::pair("Edge13", "Edge12"),
        std::pair("Vertex9", "Vertex8"), std::pair("Solid2", "Solid1"), std::pair("Face99999999999", "Face6"),
        std::pair("Face0", "'Face0' names no part"), std::pair("Face", "'Face'"),
        std::pair("face1", "'face1'"), std::pair("Wire1", "'Wire1'"), std::pair("Face1x", "'Face1x'"),
        std::pair("", "''")}) {
    try {
      reference(box, name);
      ADD_FAILURE() << name << " was taken";
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace fgmesh
