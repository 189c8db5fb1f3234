// SPDX-License-Identifier: GPL-3.0-or-later
// Jacobians of ten-node tetrahedra, against the map itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "quality/curved_tets.hpp"
#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

using Map = std::function<Vec3(const Vec3&)>;

const std::array<Vec3, 4> kCorners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

/// The image of the corner of the unit cube under a map, which is exact where the map is quadratic.
CurvedTet image(const Map& map) {
  CurvedTet nodes;
  for (int i = 0; i < 4; ++i) nodes[i] = map(kCorners[i]);
  for (int e = 0; e < 6; ++e)
    nodes[4 + e] = map(0.5 * (kCorners[kMiddleEdges[e][0]] + kCorners[kMiddleEdges[e][1]]));
  return nodes;
}

/// By central differences, which are exact for quadratic maps.
double jacobian(const Map& map, const Vec3& p) {
  constexpr double kStep = 0.25;
  const auto slope = [&](int axis) {
    const Vec3 step = kStep * Vec3::Unit(axis);
    return Vec3((map(p + step) - map(p - step)) / (2.0 * kStep));
  };
  return slope(0).cross(slope(1)).dot(slope(2));
}

Vec3 random_place(std::mt19937& random) {
  std::exponential_distribution<double> part;
  const double a = part(random), b = part(random), c = part(random);
  return Vec3(a, b, c) / (a + b + c + part(random));
}

Map random_map(std::mt19937& random, double bend) {
  std::uniform_real_distribution<double> number(-bend, bend);
  Eigen::Matrix<double, 3, 9> factor;
  for (int i = 0; i < 27; ++i) factor(i % 3, i / 3) = number(random);
  return [factor](const Vec3& p) {
    Eigen::Matrix<double, 9, 1> term;
    term << p.x() * p.x(), p.y() * p.y(), p.z() * p.z(), p.x() * p.y(), p.y() * p.z(), p.z() * p.x(), p;
    return Vec3(p + factor * term);
  };
}

SecondOrderMesh mesh_of(const CurvedTet& nodes) {
  return {{nodes.begin(), nodes.end()}, {}, {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}, {}, {}, {}};
}

/// Folds over at x = -1 / (2 slope).
Map parabola(double slope) {
  return [=](const Vec3& p) { return Vec3(p.x() + slope * p.x() * p.x(), p.y(), p.z()); };
}

TEST(JacobianCoefficients, OfStraightEdgesAreSixVolumes) {
  const CurvedTet nodes =
      image([](const Vec3& p) { return Vec3(2 * p.x() + p.y(), 3 * p.y(), p.z() - p.x()); });
  for (const double value : jacobian_coefficients(nodes)) EXPECT_NEAR(value, 6.0, 1e-12);
  EXPECT_TRUE(jacobian_is_above(nodes, 5.999));
  EXPECT_FALSE(jacobian_is_above(nodes, 6.001));
}

TEST(JacobianCoefficients, BoundTheJacobianAndMeetItAtTheCorners) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    const Map map = random_map(random, 0.4);
    const auto coefficients = jacobian_coefficients(image(map));
    const auto [low, high] = std::minmax_element(coefficients.begin(), coefficients.end());
    for (int i = 0; i < 100; ++i) {
      const double value = jacobian(map, random_place(random));
      EXPECT_GE(value, *low - 1e-12);
      EXPECT_LE(value, *high + 1e-12);
    }
    for (const Vec3& corner : kCorners) {
      const double value = jacobian(map, corner);
      EXPECT_TRUE(std::any_of(coefficients.begin(), coefficients.end(),
                              [&](double c) { return std::abs(c - value) < 1e-12; }));
    }
  }
}

TEST(JacobianIsAbove, IsNeverSaidOfATetrahedronThatFoldsOver) {
  std::mt19937 random(2);
  int proved = 0, refuted = 0;
  for (int round = 0; round < 300; ++round) {
    const Map map = random_map(random, 0.45);
    double smallest = 1e9;
    for (int i = 0; i < 2000; ++i) smallest = std::min(smallest, jacobian(map, random_place(random)));
    const bool above = jacobian_is_above(image(map), 0.0);
    if (above) {
      EXPECT_GT(smallest, 0.0);
      ++proved;
    } else {
      EXPECT_LT(smallest, 0.1) << "where it is far from zero, the proof should succeed";
      ++refuted;
    }
  }
  EXPECT_GT(proved, 30);
  EXPECT_GT(refuted, 30);
}

TEST(JacobianIsAbove, IsProvedBySubdivisionWhereTheCoefficientsAloneDoNotTell) {
  // The complex map w -> w - w^2 / (2 w0), w0 = 0.55 + 0.55i: its Jacobian |w - w0|^2 / |w0|^2 vanishes at w0
  // alone, a little outside, and is least at 0.5 + 0.5i.
  const Map map = [](const Vec3& p) {
    const double real = p.x() * p.x() - p.y() * p.y(), imaginary = 2.0 * p.x() * p.y();
    return Vec3(p.x() - (real + imaginary) / 2.2, p.y() - (imaginary - real) / 2.2, p.z());
  };
  const CurvedTet nodes = image(map);
  const auto coefficients = jacobian_coefficients(nodes);
  EXPECT_LT(*std::min_element(coefficients.begin(), coefficients.end()), -0.1);
  const double least = 0.005 / 0.605;
  EXPECT_TRUE(jacobian_is_above(nodes, 0.9 * least));
  EXPECT_FALSE(jacobian_is_above(nodes, 1.1 * least));
}

TEST(JacobianIsAbove, TellsWhereAMapFoldsOver) {
  // The slope 1 + 2 k x along x is smallest at x = 1.
  EXPECT_TRUE(jacobian_is_above(image(parabola(-0.499)), 0.0));
  EXPECT_FALSE(jacobian_is_above(image(parabola(-0.501)), 0.0));
  EXPECT_TRUE(jacobian_is_above(image(parabola(-0.45)), 0.0999));
  EXPECT_FALSE(jacobian_is_above(image(parabola(-0.45)), 0.1001));
}

TEST(VolumeOfCurvedTetrahedra, IsTheIntegralOfTheJacobian) {
  // Integral of 1 + 2 k x over the corner of the cube: 1/6 + 2 k / 24.
  EXPECT_NEAR(volume(mesh_of(image(parabola(0.3)))), 1.0 / 6.0 + 0.6 / 24.0, 1e-15);
  // Moving points along y by a function of x and z alone keeps volumes.
  const Map shear = [](const Vec3& p) {
    return Vec3(p.x(), p.y() + 0.7 * p.x() * p.x() - p.x() * p.z(), p.z());
  };
  EXPECT_NEAR(volume(mesh_of(image(shear))), 1.0 / 6.0, 1e-15);
}

TEST(CentreOfATriangle, LiesOnTheCurvedTriangle) {
  const Map map = [](const Vec3& p) { return Vec3(p.x(), p.y(), p.x() * p.x() - 2 * p.x() * p.y()); };
  const std::array<Vec3, 3> corners = {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, 3, 0)};
  SecondOrderMesh mesh;
  for (const Vec3& p : corners) mesh.points.push_back(map(p));
  for (int e = 0; e < 3; ++e)
    mesh.points.push_back(map(0.5 * (corners[kMiddleEdges[e][0]] + corners[kMiddleEdges[e][1]])));
  mesh.triangles = {{0, 1, 2, 3, 4, 5}};
  EXPECT_LT((centre_of_triangle(mesh, 0) - map(Vec3(1, 1, 0))).norm(), 1e-14);
}

}  // namespace
}  // namespace fgmesh
