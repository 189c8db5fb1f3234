// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "mesh/odt_smoothing.hpp"
#include "mesh/swap.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

/// Centre of the sphere through four points, from |c - p_i| = |c - p_0|.
Vec3 circumcentre(const std::array<Vec3, 4>& p) {
  Eigen::Matrix3d rows;
  Vec3 right;
  for (int i = 1; i < 4; ++i) {
    rows.row(i - 1) = 2.0 * (p[i] - p[0]).transpose();
    right[i - 1] = p[i].squaredNorm() - p[0].squaredNorm();
  }
  return rows.fullPivLu().solve(right);
}

/// Equation 2.6, with the size mu given as a function of the centroid; 2.5 where it is constant.
Vec3 equation_2_6(const MeshState& state, const std::vector<int>& star,
                  const std::function<double(const Vec3&)>& mu) {
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  for (const int t : star) {
    std::array<Vec3, 4> p;
    for (int i = 0; i < 4; ++i) p[i] = state.position(state.complex.tet(t).vertex[i]);
    const Vec3 centroid = (p[0] + p[1] + p[2] + p[3]) / 4.0;
    const double weight =
        std::abs((p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0])) / 6.0 / std::pow(mu(centroid), 3);
    sum += weight * circumcentre(p);
    weights += weight;
  }
  return sum / weights;
}

std::vector<int> star_of(const MeshState& state, int v) {
  std::vector<int> star;
  state.complex.star(v, star);
  return star;
}

/// The twenty tetrahedra between the centre (vertex 12) and the faces of an icosahedron.
struct Icosahedron {
  Icosahedron() {
    const double golden = 0.5 * (1.0 + std::sqrt(5.0));
    TetMesh mesh;
    for (const double s : {-1.0, 1.0}) {
      for (const double t : {-golden, golden}) {
        mesh.points.insert(mesh.points.end(), {Vec3(0, s, t), Vec3(s, t, 0), Vec3(t, 0, s)});
      }
    }
    mesh.points.push_back(Vec3::Zero());
    for (int a = 0; a < 12; ++a)
      for (int b = a + 1; b < 12; ++b)
        for (int c = b + 1; c < 12; ++c) add_face(mesh, {a, b, c});
    mesh.carriers.assign(13, {2, 1});
    mesh.carriers[12] = {3, 1};
    mesh.tet_solids.assign(mesh.tets.size(), 1);
    test::load(state, mesh, 1.0);
  }

  static void add_face(TetMesh& mesh, std::array<std::int32_t, 3> face) {
    for (int k = 0; k < 3; ++k)
      if ((mesh.points[face[k]] - mesh.points[face[(k + 1) % 3]]).norm() > 2.0 + 1e-9) return;
    const Vec3& p = mesh.points[face[0]];
    if ((mesh.points[face[1]] - p).cross(mesh.points[face[2]] - p).dot(p) < 0.0) std::swap(face[1], face[2]);
    mesh.triangles.push_back(face);
    mesh.triangle_faces.push_back(1);
    mesh.tets.push_back({12, face[0], face[1], face[2]});
  }

  const test::BallSolid ball{std::sqrt(1.0 + std::pow(0.5 * (1.0 + std::sqrt(5.0)), 2))};
  const test::FunctionField field = test::constant(0.5);
  MeshState state{ball, field, 0.1, 4.0};
};

TEST(OdtTarget, OfTheCentreOfARegularStarIsTheCentre) {
  const Icosahedron icosahedron;
  ASSERT_EQ(icosahedron.state.complex.tet_count(), 20);
  EXPECT_NEAR(odt_target(icosahedron.state, 12, star_of(icosahedron.state, 12)).norm(), 0.0, 1e-14);
}

TEST(OdtTarget, IsTheSameWhereverTheVertexOfAStarOnASphereStands) {
  // With all neighbours on one sphere the energy of the star is least at its centre, where every |x|^2 meets
  // the sphere's: the target does not depend on where the vertex comes from.
  Icosahedron icosahedron;
  for (const Vec3& place : {Vec3(0.3, 0, 0), Vec3(-0.2, 0.4, 0.1), Vec3(0, 0.1, -0.7)}) {
    icosahedron.state.vertices[12].position = place;
    EXPECT_NEAR(odt_target(icosahedron.state, 12, star_of(icosahedron.state, 12)).norm(), 0.0, 1e-13);
  }
}

TEST(OdtTarget, IsEquation25WhereTheSizeIsConstant) {
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.3, 1);
  int inner = 0;
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    if (mesh.state.vertices[v].carrier.dimension != 3) continue;
    const std::vector<int> star = star_of(mesh.state, v);
    const Vec3 expected = equation_2_6(mesh.state, star, [](const Vec3&) { return 0.5; });
    EXPECT_NEAR((odt_target(mesh.state, v, star) - expected).norm(), 0.0, 1e-10);
    ++inner;
  }
  EXPECT_EQ(inner, 27);
}

TEST(OdtTarget, IsEquation26WhereTheSizeGrowsSteadily) {
  // Linear, so that the mean over the vertices is what stands at the centroid.
  const auto mu = [](const Vec3& p) { return 0.4 + p.dot(Vec3(0.3, 0.1, -0.05)); };
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.3, 2);
  for (Vertex& vertex : mesh.state.vertices) vertex.size = mu(vertex.position);
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    if (mesh.state.vertices[v].carrier.dimension != 3) continue;
    const std::vector<int> star = star_of(mesh.state, v);
    EXPECT_NEAR((odt_target(mesh.state, v, star) - equation_2_6(mesh.state, star, mu)).norm(), 0.0, 1e-10);
  }
}

TEST(OdtTarget, HasTheLeastEnergyOfTheStar) {
  // Chen and Xu (2004): with the connectivity kept, the interpolation error of |x|^2 is least there.
  test::GridMesh mesh(2.0, 3);
  mesh.shake(0.3, 4);
  const OdtEnergy energy(mesh.state);
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    if (mesh.state.vertices[v].carrier.dimension != 3) continue;
    const std::vector<int> star = star_of(mesh.state, v);
    const auto error_at = [&](const Vec3& p) {
      double sum = 0.0;
      for (const int t : star) {
        std::array<Vec3, 4> q;
        double squares = 0.0;
        for (int i = 0; i < 4; ++i) {
          const int w = mesh.state.complex.tet(t).vertex[i];
          q[i] = w == v ? p : mesh.state.position(w);
          squares += q[i].squaredNorm();
        }
        sum += squares * (q[1] - q[0]).cross(q[2] - q[0]).dot(q[3] - q[0]);
      }
      return sum;
    };
    const Vec3 target = odt_target(mesh.state, v, star);
    for (int axis = 0; axis < 3; ++axis) {
      // Central differences of a quadratic function are exact.
      const Vec3 step = 0.1 * Vec3::Unit(axis);
      EXPECT_NEAR(error_at(target + step) - error_at(target - step), 0.0, 1e-12);
      EXPECT_GT(error_at(target + step), error_at(target));
    }
  }
}

TEST(OdtTarget, OnAFaceStaysInItsPlaneAndDependsOnItAlone) {
  // In the plane, too, the error of |x|^2 over the triangles around the vertex is least at the target.
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.3, 6);
  int checked = 0;
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    const Carrier& carrier = mesh.state.vertices[v].carrier;
    if (carrier.dimension != 2) continue;
    const std::vector<int> star = star_of(mesh.state, v);
    const Vec3 target = odt_target(mesh.state, v, star);
    const Vec3 normal = mesh.solid.project_to_face(carrier.number, mesh.state.position(v)).normal;
    EXPECT_NEAR(normal.dot(target - mesh.state.position(v)), 0.0, 1e-13);
    const auto error_at = [&](const Vec3& p) {
      double sum = 0.0;
      for (const int t : star) {
        const Tet& tet = mesh.state.complex.tet(t);
        for (int i = 0; i < 4; ++i) {
          if (tet.label[i] != carrier.number || tet.vertex[i] == v) continue;
          std::array<Vec3, 3> q;
          double squares = 0.0;
          for (int k = 0; k < 3; ++k) {
            const int w = tet.vertex[kFaceVertices[i][k]];
            q[k] = w == v ? p : mesh.state.position(w);
            squares += q[k].squaredNorm();
          }
          sum += squares * (q[1] - q[0]).cross(q[2] - q[0]).dot(normal);
        }
      }
      return sum;
    };
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = 0.05 * (Vec3::Unit(axis) - normal[axis] * normal);
      EXPECT_NEAR(error_at(target + step) - error_at(target - step), 0.0, 1e-12);
    }
    ++checked;
  }
  EXPECT_EQ(checked, 6 * 9);
}

TEST(OdtTarget, OnAnEdgeIsHalfWayBetweenTheNeighbours) {
  test::GridMesh mesh(3.0, 3);
  mesh.shake(0.3, 7);
  int checked = 0;
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    if (mesh.state.vertices[v].carrier.dimension != 1) continue;
    Vec3 ends = Vec3::Zero();
    int neighbours = 0;
    for (const auto& [a, b, edge] : mesh.state.complex.creases()) {
      if (a != v && b != v) continue;
      ends += mesh.state.position(a == v ? b : a);
      ++neighbours;
    }
    ASSERT_EQ(neighbours, 2);
    EXPECT_NEAR((odt_target(mesh.state, v, star_of(mesh.state, v)) - 0.5 * ends).norm(), 0.0, 1e-13);
    ++checked;
  }
  EXPECT_EQ(checked, 24);
}

TEST(OdtTarget, OfACornerIsTheCorner) {
  test::GridMesh mesh(3.0, 2);
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v)
    if (mesh.state.vertices[v].carrier.dimension == 0) {
      EXPECT_EQ(odt_target(mesh.state, v, star_of(mesh.state, v)), mesh.state.position(v));
    }
}

}  // namespace
}  // namespace fgmesh
