// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes in the middle of edges, on solids in closed form. Lengths in mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "box_grid.hpp"
#include "core/error.hpp"
#include "mesh/initial.hpp"
#include "mesh/second_order.hpp"
#include "mesh_checks.hpp"
#include "quality/curved_tets.hpp"
#include "quality/mesh_statistics.hpp"

namespace fgmesh {
namespace {

const test::FunctionField kField = test::constant(0.5);

TetMesh initial_mesh(const test::AnalyticSolid& solid, double part_of_diagonal) {
  const SampledBoundary samples = solid.samples();
  const double size = part_of_diagonal * samples.bounds.diagonal();
  MeshState state(solid, kField, 0.1, samples.bounds.diagonal());
  state.chord_limit = 0.05 * size;
  RunControl control;
  make_initial_mesh(state, samples, {size, state.chord_limit}, control);
  return state.to_tet_mesh();
}

SecondOrderMesh raised(const TetMesh& mesh, const BoundaryGeometry& boundary) {
  RunControl control;
  return make_second_order(mesh, boundary, control);
}

/// Position in a ten-node tetrahedron, by the shape functions of the textbooks.
Vec3 position(const CurvedTet& nodes, const std::array<double, 4>& part) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 4; ++i) sum += part[i] * (2.0 * part[i] - 1.0) * nodes[i];
  for (int e = 0; e < 6; ++e) sum += 4.0 * part[kMiddleEdges[e][0]] * part[kMiddleEdges[e][1]] * nodes[4 + e];
  return sum;
}

/// By central differences, which are exact for quadratics.
double jacobian(const CurvedTet& nodes, const std::array<double, 4>& part) {
  Vec3 slope[3];
  for (int k = 0; k < 3; ++k) {
    std::array<double, 4> ahead = part, behind = part;
    ahead[k + 1] += 0.25, ahead[0] -= 0.25;
    behind[k + 1] -= 0.25, behind[0] += 0.25;
    slope[k] = 2.0 * (position(nodes, ahead) - position(nodes, behind));
  }
  return slope[0].cross(slope[1]).dot(slope[2]);
}

/// Smallest found at random points and at corners, as part of that of the straight tetrahedron.
double smallest_jacobian(const SecondOrderMesh& mesh, int points) {
  std::mt19937 random(7);
  std::exponential_distribution<double> number;
  double smallest = 1e9;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const CurvedTet nodes = curved_tet(mesh, t);
    const double straight = orientation(nodes[0], nodes[1], nodes[2], nodes[3]);
    for (int i = 0; i < points + 4; ++i) {
      std::array<double, 4> part;
      for (int k = 0; k < 4; ++k) part[k] = i < 4 ? i == k : number(random);
      const double sum = part[0] + part[1] + part[2] + part[3];
      for (double& value : part) value /= sum;
      smallest = std::min(smallest, jacobian(nodes, part) / straight);
    }
  }
  return smallest;
}

/// What is wrong with a mesh of second order over `mesh`, in words.
std::string find_fault(const SecondOrderMesh& raised, const TetMesh& mesh) {
  const std::size_t corners = mesh.points.size();
  if (!std::equal(mesh.points.begin(), mesh.points.end(), raised.points.begin())) return "corners have moved";
  if (raised.carriers.size() != raised.points.size()) return "not every point has a carrier";
  std::map<std::pair<int, int>, int> node_of;
  std::set<int> nodes;
  std::string fault;
  const auto see = [&](int a, int b, int node) {
    if (node < static_cast<int>(corners)) fault = "a corner stands in the middle";
    const auto [place, fresh] = node_of.emplace(std::minmax(a, b), node);
    if (place->second != node) fault = "an edge has two nodes";
    nodes.insert(node);
  };
  const auto see_row = [&](const auto& row, const auto& linear) {
    if (!std::equal(linear.begin(), linear.end(), row.begin())) fault = "corners differ";
    for (std::size_t k = linear.size(); k < row.size(); ++k) {
      const auto& [i, j] = kMiddleEdges[k - linear.size()];
      see(row[i], row[j], row[k]);
    }
  };
  if (raised.tets.size() != mesh.tets.size() || raised.triangles.size() != mesh.triangles.size() ||
      raised.edges.size() != mesh.edges.size())
    return "elements are missing";
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) see_row(raised.tets[t], mesh.tets[t]);
  const std::size_t known = node_of.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) see_row(raised.triangles[t], mesh.triangles[t]);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) see_row(raised.edges[e], mesh.edges[e]);
  if (node_of.size() != known) fault = "a triangle or an edge has a node of no tetrahedron";
  if (nodes.size() != node_of.size()) fault = "two edges share a node";
  if (corners + nodes.size() != raised.points.size()) fault = "there are points without use";
  return fault;
}

struct Part {
  std::string name;
  std::shared_ptr<test::AnalyticSolid> solid;
};

void PrintTo(const Part& part, std::ostream* stream) { *stream << part.name; }

class SecondOrder : public testing::TestWithParam<Part> {
 protected:
  const test::AnalyticSolid& solid = *GetParam().solid;
};

TEST_P(SecondOrder, PutsNodesOnTheTrueBoundaryAndHalfwayInside) {
  const TetMesh mesh = initial_mesh(solid, 0.1);
  const SecondOrderMesh found = raised(mesh, solid);
  ASSERT_EQ(find_fault(found, mesh), "");
  std::vector<Carrier> follows(found.points.size());
  for (std::size_t i = 0; i < found.triangles.size(); ++i)
    for (int k = 3; k < 6; ++k) follows[found.triangles[i][k]] = {2, mesh.triangle_faces[i]};
  for (std::size_t i = 0; i < found.edges.size(); ++i) follows[found.edges[i][2]] = {1, mesh.edge_edges[i]};
  const std::set<int> straightened(found.straightened.begin(), found.straightened.end());
  EXPECT_LT(straightened.size(), 0.05 * mesh.triangles.size());
  for (const auto& row : found.tets) {
    for (int k = 0; k < 6; ++k) {
      const int node = row[4 + k];
      const auto& [i, j] = kMiddleEdges[k];
      const Vec3& p = found.points[node];
      const Vec3 middle = 0.5 * (found.points[row[i]] + found.points[row[j]]);
      Vec3 place = middle;
      if (follows[node].dimension == 1) place = solid.project_to_edge(follows[node].number, middle).position;
      if (follows[node].dimension == 2) place = solid.project_to_face(follows[node].number, middle).position;
      if (straightened.count(node)) {
        EXPECT_LT(follows[node].dimension, 3);
        EXPECT_EQ(found.carriers[node].dimension, 3);
        EXPECT_LT((p - middle).norm(), 0.51 * (place - middle).norm());
      } else {
        EXPECT_EQ(found.carriers[node].dimension, follows[node].dimension);
        EXPECT_EQ(found.carriers[node].number, follows[node].number);
        EXPECT_LT((p - place).norm(), 1e-12);
      }
    }
  }
}

TEST_P(SecondOrder, HasPositiveJacobians) {
  const SecondOrderMesh found = raised(initial_mesh(solid, 0.15), solid);
  EXPECT_GT(smallest_jacobian(found, 50), 0.1 - 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Of, SecondOrder,
                         testing::Values(Part{"Box", std::make_shared<test::BoxSolid>(Box{Vec3(-10, 0, 5),
                                                                                          Vec3(20, 15, 15)})},
                                         Part{"Ball", std::make_shared<test::BallSolid>(10.0)},
                                         Part{"Cylinder", std::make_shared<test::CylinderSolid>(5.0, 20.0)}),
                         [](const auto& info) { return info.param.name; });

/// Errors of the volume of the straight and of the curved mesh, as parts of it.
std::array<double, 2> volume_errors(const test::AnalyticSolid& solid, double part_of_diagonal) {
  const TetMesh mesh = initial_mesh(solid, part_of_diagonal);
  return {std::abs(volume(mesh) / solid.volume() - 1.0),
          std::abs(volume(raised(mesh, solid)) / solid.volume() - 1.0)};
}

TEST(SecondOrderVolume, ConvergesWithTheFourthPowerOfTheSizeWhereThatOfStraightMeshesDoesWithTheSecond) {
  const test::BallSolid ball(10.0);
  const test::CylinderSolid cylinder(10.0, 15.0);
  const std::array<const test::AnalyticSolid*, 2> solids = {&ball, &cylinder};
  for (const test::AnalyticSolid* solid : solids) {
    const auto [coarse_straight, coarse_curved] = volume_errors(*solid, 0.16);
    const auto [fine_straight, fine_curved] = volume_errors(*solid, 0.04);
    EXPECT_LT(coarse_curved, coarse_straight / 20.0);
    EXPECT_LT(fine_straight, coarse_straight / 3.0);
    // Twice the power, within a tenth: the two meshes differ by more than their size.
    EXPECT_NEAR(std::log(coarse_curved / fine_curved) / std::log(coarse_straight / fine_straight), 2.0, 0.2);
  }
}

TEST(SecondOrderVolume, OfFlatPartsIsThatOfTheStraightMesh) {
  const Box box{Vec3::Zero(), Vec3(3, 2, 1)};
  const TetMesh mesh = test::box_grid(box, {3, 2, 2}, 2);
  const SecondOrderMesh found = raised(mesh, test::BoxSolid(box));
  EXPECT_EQ(find_fault(found, mesh), "");
  EXPECT_NEAR(volume(found), 6.0, 1e-12);
}

/// A tetrahedron on a spherical hole of 10 mm about the origin: the three corners of its facet lie on the
/// hole, 30 degrees from the z axis, the fourth `height` above the facet. A second one has an edge of the
/// facet and stands beside it.
TetMesh at_a_hole(double height) {
  TetMesh mesh;
  const double z = 10.0 * std::cos(M_PI / 6.0);
  for (const double angle : {0.0, 120.0, 240.0})
    mesh.points.emplace_back(5.0 * std::cos(angle * M_PI / 180.0), 5.0 * std::sin(angle * M_PI / 180.0), z);
  mesh.points.emplace_back(0, 0, z + height);
  mesh.points.emplace_back(10, 10, z + 5.0);
  mesh.tets = {{0, 1, 2, 3}, {0, 1, 3, 4}};
  mesh.carriers = {{2, 1}, {2, 1}, {2, 1}, {3, 1}, {3, 1}};
  mesh.tet_solids = {1, 1};
  mesh.triangles = {{0, 2, 1}};
  mesh.triangle_faces = {1};
  return mesh;
}

TEST(SecondOrderAtAHole, FollowsItWhereThereIsRoom) {
  const TetMesh mesh = at_a_hole(6.0);
  const SecondOrderMesh found = raised(mesh, test::BallSolid(10.0));
  EXPECT_EQ(find_fault(found, mesh), "");
  EXPECT_TRUE(found.straightened.empty());
  for (int k = 3; k < 6; ++k) EXPECT_NEAR(found.points[found.triangles[0][k]].norm(), 10.0, 1e-12);
}

TEST(SecondOrderAtAHole, GivesCurvesUpWhereATetrahedronWouldBeTurnedOver) {
  // The true boundary is 1.34 mm above the middle of the facet, the middles of its edges up to 0.32 mm.
  for (const double height : {0.02, 0.1, 0.3, 0.6, 1.0}) {
    const TetMesh mesh = at_a_hole(height);
    const SecondOrderMesh found = raised(mesh, test::BallSolid(10.0));
    EXPECT_EQ(find_fault(found, mesh), "");
    EXPECT_GT(smallest_jacobian(found, 500), 0.1 - 1e-9) << height;
    const std::set<int> off(found.straightened.begin(), found.straightened.end());
    for (int k = 3; k < 6; ++k) {
      const int node = found.triangles[0][k];
      const bool on = std::abs(found.points[node].norm() - 10.0) < 1e-12;
      EXPECT_EQ(on, off.count(node) == 0);
      EXPECT_EQ(found.carriers[node].dimension, on ? 2 : 3);
    }
    EXPECT_FALSE(off.empty());
  }
}

TEST(SecondOrderRun, IsCancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(
      make_second_order(test::box_grid(1.0, 2), test::BoxSolid({Vec3::Zero(), Vec3::Ones()}), control),
      Cancelled);
}

}  // namespace
}  // namespace fgmesh
