// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

using Corners = std::array<Vec3, 4>;

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

const Corners kRegular = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
const Corners kCorner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};

std::array<double, 6> angles(const Corners& p) {
  std::array<double, 6> result = dihedral_cosines(p[0], p[1], p[2], p[3]);
  for (double& value : result) value = std::acos(std::clamp(value, -1.0, 1.0)) / kDegree;
  return result;
}

AngleRange range(const Corners& p) { return dihedral_range(p[0], p[1], p[2], p[3]); }

Corners random_tet(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  Corners p;
  do {
    for (Vec3& corner : p) {
      const double x = coordinate(random), y = coordinate(random);
      corner = Vec3(x, y, coordinate(random));
    }
  } while (orientation(p[0], p[1], p[2], p[3]) < 0.05);
  return p;
}

TEST(DihedralAngles, OfTheRegularTetrahedron) {
  for (const double angle : angles(kRegular)) EXPECT_NEAR(angle, std::acos(1.0 / 3.0) / kDegree, 1e-12);
  EXPECT_NEAR(range(kRegular).smallest, 70.528779365509308, 1e-12);
  EXPECT_NEAR(range(kRegular).largest, 70.528779365509308, 1e-12);
}

TEST(DihedralAngles, OfACornerOfACubeInTheOrderOfTheEdges) {
  const std::array<double, 6> found = angles(kCorner);
  for (int edge = 0; edge < 3; ++edge) EXPECT_NEAR(found[edge], 90.0, 1e-12);
  for (int edge = 3; edge < 6; ++edge)
    EXPECT_NEAR(found[edge], std::acos(1.0 / std::sqrt(3.0)) / kDegree, 1e-12);
}

TEST(DihedralAngles, OfASixthOfACubeInTheOrderOfTheEdges) {
  // Six of these stand around the cube's diagonal 0-3; two share each of the cube's edges 0-1 and 2-3.
  const Corners kuhn = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)};
  const std::array<double, 6> expected = {45.0, 90.0, 60.0, 90.0, 90.0, 45.0}, found = angles(kuhn);
  for (int edge = 0; edge < 6; ++edge) EXPECT_NEAR(found[edge], expected[edge], 1e-12) << "edge " << edge;
}

TEST(DihedralAngles, OfSlivers) {
  // Two crossing segments of length 2, 2 h apart: 2 atan(1 / 2h) at them. The cosines at the three edges of a
  // face sum to 1 where all faces are alike.
  for (const double h : {1e-1, 1e-2, 1e-4}) {
    const Corners sliver = {Vec3(1, 0, h), Vec3(-1, 0, h), Vec3(0, 1, -h), Vec3(0, -1, -h)};
    const double largest = 2.0 * std::atan(0.5 / h), cosine = 0.5 * (1.0 - std::cos(largest));
    EXPECT_NEAR(range(sliver).largest, largest / kDegree, 1e-6) << h;
    EXPECT_NEAR(range(sliver).smallest, std::acos(cosine) / kDegree, 1e-6) << h;
  }
}

TEST(DihedralAngles, OfFlatTetrahedraAreTheWorst) {
  const Corners flat = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)};
  EXPECT_NEAR(range(flat).smallest, 0.0, 1e-5);
  EXPECT_NEAR(range(flat).largest, 180.0, 1e-5);
  const Corners with_flat_face = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 1)};
  EXPECT_EQ(range(with_flat_face).smallest, 0.0);
  const Corners point = {Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1)};
  EXPECT_EQ(range(point).smallest, 0.0);
}

TEST(DihedralAngles, DependNeitherOnSizeNorPlaceNorTurn) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Corners tet = random_tet(random);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.1 * trial + 0.3, Vec3(1.0, 0.2 * trial, -0.7).normalized()).toRotationMatrix();
    for (const double scale : {1e-6, 1.0, 1e6}) {
      Corners moved;
      for (int i = 0; i < 4; ++i) moved[i] = scale * (turn * tet[i] + Vec3(3, -5, 2));
      EXPECT_NEAR(range(moved).smallest, range(tet).smallest, 1e-6);
      EXPECT_NEAR(range(moved).largest, range(tet).largest, 1e-6);
    }
  }
}

TEST(DihedralAngles, AroundAnInnerEdgeSumToAFullTurn) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> radius(0.3, 3.0);
  const Vec3 low(0.1, 0.2, -1.3), high(-0.2, 0.1, 1.1);
  std::array<Vec3, 7> link;
  for (std::size_t i = 0; i < link.size(); ++i) {
    const double angle = 2.0 * kPi * (i + 0.3 * radius(random) / 3.0) / link.size(), r = radius(random);
    link[i] = Vec3(r * std::cos(angle), r * std::sin(angle), 0.2 * radius(random));
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < link.size(); ++i) sum += angles({low, high, link[i], link[(i + 1) % 7]})[0];
  EXPECT_NEAR(sum, 360.0, 1e-9);
}

TEST(Volume, IsThatOfTheParallelepipedOverSix) {
  EXPECT_DOUBLE_EQ(signed_volume(kCorner[0], kCorner[1], kCorner[2], kCorner[3]), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(signed_volume(kCorner[1], kCorner[0], kCorner[2], kCorner[3]), -1.0 / 6.0);
  EXPECT_DOUBLE_EQ(orientation(kCorner[0], kCorner[1], kCorner[2], kCorner[3]), 1.0);
  const double edge = 2.0 * std::sqrt(2.0);
  EXPECT_NEAR(std::abs(signed_volume(kRegular[0], kRegular[1], kRegular[2], kRegular[3])),
              edge * edge * edge / (6.0 * std::sqrt(2.0)), 1e-12);
  EXPECT_NEAR(squared_edges(kRegular[0], kRegular[1], kRegular[2], kRegular[3]), 6.0 * edge * edge, 1e-12);
}

TEST(Faces, LookOutwardAndAreOppositeTheirVertex) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const Corners p = random_tet(random);
    for (int i = 0; i < 4; ++i) {
      const int* face = kFaceVertices[i];
      ASSERT_EQ(face[0] + face[1] + face[2] + i, 6) << "face " << i << " has vertex " << i;
      const Vec3 normal = area_vector(p[face[0]], p[face[1]], p[face[2]]);
      EXPECT_LT(normal.dot(p[i] - p[face[0]]), 0.0);
    }
  }
}

TEST(Edges, AndTheirOppositesShareNoVertex) {
  for (int e = 0; e < 6; ++e)
    for (const int v : kEdgeVertices[e])
      EXPECT_TRUE(v != kEdgeVertices[5 - e][0] && v != kEdgeVertices[5 - e][1]) << "edge " << e;
}

}  // namespace
}  // namespace fgmesh
