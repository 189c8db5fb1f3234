// SPDX-License-Identifier: GPL-3.0-or-later
// Splitting and collapsing edges, one at a time.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/edge_collapse.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/initial.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An edge of the mesh whose ends are carried by entities of these dimensions and whose own middle lies on
/// one of dimension `middle`: its ends and a tetrahedron that has it.
struct FoundEdge {
  int a = -1, b = -1, t = -1;
};

FoundEdge edge_on(const test::GridMesh& mesh, int middle) {
  const Box box{Vec3::Zero(), Vec3::Constant(mesh.side)};
  for (int t = 0; t < mesh.state.complex.slots(); ++t) {
    for (const auto& [i, j] : kEdgeVertices) {
      const int a = mesh.state.complex.tet(t).vertex[i], b = mesh.state.complex.tet(t).vertex[j];
      const Vec3 centre = 0.5 * (mesh.state.position(a) + mesh.state.position(b));
      if (test::carrier_in_box(box, centre).dimension == middle) return {a, b, t};
    }
  }
  ADD_FAILURE() << "no such edge";
  return {};
}

class SplitEdge : public testing::TestWithParam<int> {};

TEST_P(SplitEdge, PutsAVertexOnTheCarrierOfTheEdge) {
  test::GridMesh mesh(3.0, 3, test::linear(Vec3(0.1, 0.1, 0.05)));
  const int dimension = GetParam();
  const auto [a, b, t] = edge_on(mesh, dimension);
  const Vec3 middle = 0.5 * (mesh.state.position(a) + mesh.state.position(b));
  EdgeRing ring;
  mesh.state.complex.ring(a, b, t, ring);
  const int before = mesh.state.complex.tet_count();
  const int crease = mesh.state.complex.crease(a, b);
  ASSERT_EQ(crease != 0, dimension == 1);

  const int v = split_edge(mesh.state, a, b, t);
  ASSERT_GE(v, 0);
  const Vertex& vertex = mesh.state.vertices[v];
  EXPECT_NEAR((vertex.position - middle).norm(), 0.0, 1e-14);
  EXPECT_EQ(vertex.carrier.dimension, dimension);
  const Carrier expected = test::carrier_in_box({Vec3::Zero(), Vec3::Constant(3.0)}, middle);
  EXPECT_EQ(vertex.carrier.number, expected.number);
  EXPECT_DOUBLE_EQ(vertex.own.composition[0], middle.dot(Vec3(0.1, 0.1, 0.05)));
  EXPECT_EQ(vertex.own.gradient[0], Vec3(0.1, 0.1, 0.05));

  EXPECT_EQ(mesh.state.complex.tet_count(), before + static_cast<int>(ring.tet.size()));
  EXPECT_EQ(mesh.state.complex.find_edge(a, b), -1);
  EXPECT_EQ(mesh.state.complex.crease(a, b), 0);
  EXPECT_EQ(mesh.state.complex.crease(a, v), crease);
  EXPECT_EQ(mesh.state.complex.crease(v, b), crease);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_NEAR(test::volume_of(mesh.state), 27.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Carrier, SplitEdge, testing::Values(1, 2, 3), [](const auto& info) {
  return std::string(info.param == 1 ? "Crease" : info.param == 2 ? "Face" : "Inside");
});

/// A box whose face 1 is, for projection alone, a plane deep inside it.
class DentedBox final : public test::BoxSolid {
 public:
  DentedBox(double side, double depth) : BoxSolid({Vec3::Zero(), Vec3::Constant(side)}), depth_(depth) {}
  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess) const override {
    SurfacePoint found = BoxSolid::project_to_face(face, p, guess);
    if (face == 1) found.position.x() = depth_;
    return found;
  }

 private:
  double depth_;
};

/// Splits each inner edge of face 1 of its own copy of a box of 3^3 cells whose face 1 is at `depth`.
template <class Check>
int split_into_depth(double depth, Check&& check) {
  const test::FunctionField field = test::constant(0.5);
  const DentedBox dented(3.0, depth);
  const test::GridMesh mesh(3.0, 3);
  int tried = 0;
  for (int t = 0; t < mesh.state.complex.slots(); ++t) {
    const Tet& tet = mesh.state.complex.tet(t);
    for (int face = 0; face < 4; ++face) {
      if (tet.label[face] != 1) continue;
      const int a = tet.vertex[kFaceVertices[face][0]], b = tet.vertex[kFaceVertices[face][1]];
      if (mesh.state.complex.crease(a, b)) continue;
      MeshState state(dented, field, 0.1, 5.0);
      state.complex = mesh.state.complex;
      state.vertices = mesh.state.vertices;
      check(mesh.state, state, split_edge(state, a, b, t));
      ++tried;
    }
  }
  return tried;
}

TEST(SplitEdgeOfAHollowWall, OpensTheTetrahedraInTheWay) {
  int deep = 0;
  const int tried = split_into_depth(1.2, [&](const MeshState& before, const MeshState& after, int v) {
    if (v < 0) return;  // beside another wall
    ++deep;
    EXPECT_EQ(after.position(v).x(), 1.2);
    // Every facet of the wall at the new vertex bounds a tetrahedron that is gone, in the cone of the dent.
    EXPECT_LT(test::volume_of(after), test::volume_of(before) - 0.1);
    for (int t = 0; t < after.complex.slots(); ++t) {
      const Tet& tet = after.complex.tet(t);
      if (!tet.alive()) continue;
      EXPECT_GT(orientation(after.position(tet.vertex[0]), after.position(tet.vertex[1]),
                            after.position(tet.vertex[2]), after.position(tet.vertex[3])),
                0.0);
      for (int i = 0; i < 4; ++i) {
        if (tet.neighbour[i] < 0) {
          EXPECT_NE(tet.label[i], 0);
        } else {
          const auto& back = after.complex.tet(tet.neighbour[i]).neighbour;
          EXPECT_EQ(std::count(back.begin(), back.end(), t), 1);
        }
      }
    }
  });
  EXPECT_GT(tried, 10);
  EXPECT_GT(deep, tried / 2);
}

TEST(SplitEdgeBeyondTheFarWall, ChangesNothing) {
  split_into_depth(3.5, [](const MeshState& before, const MeshState& after, int v) {
    EXPECT_EQ(v, -1);
    EXPECT_EQ(after.complex.tet_count(), before.complex.tet_count());
    ASSERT_EQ(after.vertices.size(), before.vertices.size());
    for (std::size_t w = 0; w < after.vertices.size(); ++w)
      EXPECT_EQ(after.position(static_cast<int>(w)), before.position(static_cast<int>(w)));
  });
}

TEST(SplitEdgeWhereTheMaterialIsWrong, NamesThePoint) {
  test::GridMesh mesh(
      2.0, 2, test::along_x([](double x) { return x == 0.5 ? 1.25 : 0.5; }, [](double) { return 0.0; }));
  for (int t = 0; t < mesh.state.complex.slots(); ++t) {
    for (const auto& [i, j] : kEdgeVertices) {
      const int a = mesh.state.complex.tet(t).vertex[i], b = mesh.state.complex.tet(t).vertex[j];
      if (mesh.state.position(a).x() + mesh.state.position(b).x() != 1.0) continue;
      try {
        split_edge(mesh.state, a, b, t);
        FAIL() << "a fraction of 1.25 went through";
      } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("1.25"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("(0.5, "), std::string::npos) << error.what();
      }
      EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
      return;
    }
  }
}

TEST(AMaterialOfThreeConstituents, IsRefusedWhereItsFractionsSumUpToMoreThanOne) {
  const test::Mixture mixture(
      {test::linear(Vec3(0.4, 0, 0)), test::linear(Vec3(0, 0.4, 0)), test::constant(0.1)});
  const test::BoxSolid box(Box{Vec3::Zero(), Vec3::Constant(2)});
  const MeshState state(box, mixture, 0.1, 1.0);
  Vertex vertex;
  vertex.position = Vec3(1, 1, 1);
  ASSERT_TRUE(state.evaluate(vertex));
  EXPECT_EQ(vertex.own.composition, (Composition{0.4, 0.4, 0.1}));
  vertex.position = Vec3(1.5, 1.25, 1);
  try {
    state.evaluate(vertex);
    FAIL() << "a sum of 1.2 went through";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("sum up to 1.2, more than 1, at the point (1.5, 1.25, 1)"),
              std::string::npos)
        << error.what();
  }
}

class CollapseEdgeOn : public testing::TestWithParam<int> {};

TEST_P(CollapseEdgeOn, TakesAVertexOfThisDimensionAwayAndKeepsTheRest) {
  test::GridMesh mesh(3.0, 3);
  mesh.state.chord_limit = 1e-9;
  const TetScore score(mesh.state, {1.0, 179.0, false});
  const auto [a, b, t] = edge_on(mesh, GetParam());
  const int vertices = test::vertex_count(mesh.state), v = split_edge(mesh.state, a, b, t);
  ASSERT_GE(v, 0);
  const int before = mesh.state.complex.tet_count();
  const std::size_t creases = mesh.state.complex.creases().size();
  std::vector<int> star;
  mesh.state.complex.star(v, star);
  ASSERT_TRUE(collapse_edge(mesh.state, v, b, score, 0.0));
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
  EXPECT_EQ(mesh.state.complex.tet_at(v), -1);
  EXPECT_EQ(test::vertex_count(mesh.state), vertices);
  EXPECT_EQ(mesh.state.complex.tet_count(), before - static_cast<int>(star.size()) / 2);
  EXPECT_EQ(mesh.state.complex.creases().size(), creases - (GetParam() == 1));
  EXPECT_NEAR(test::volume_of(mesh.state), 27.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Dimension, CollapseEdgeOn, testing::Values(1, 2, 3));

TEST(CollapseEdge, NeverTakesAVertexOffItsCarrier) {
  test::GridMesh mesh(3.0, 3);
  mesh.state.chord_limit = 1e-9;
  const TetScore score(mesh.state, {1.0, 179.0, false});
  const auto carrier = [&](int v) { return mesh.state.vertices[v].carrier; };
  for (int v = 0; v < mesh.state.complex.vertex_slots(); ++v) {
    const Tet tet = mesh.state.complex.tet(mesh.state.complex.tet_at(v));
    for (const int w : tet.vertex) {
      const bool along =
          carrier(w).dimension < carrier(v).dimension ||
          (carrier(w).dimension == carrier(v).dimension && carrier(w).number == carrier(v).number);
      if (w != v && (!along || carrier(v).dimension == 0)) {
        EXPECT_FALSE(collapse_edge(mesh.state, v, w, score, -kInfinity));
      }
    }
  }
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
}

TEST(CollapseEdge, KeepsTheScoreAskedFor) {
  // One cell is a third wide: a tetrahedron without an inner vertex reaches across two.
  test::GridMesh mesh(3.0, 3, test::linear(Vec3(1.0 / 3.0, 0, 0)), 0.4);
  const TetScore score(mesh.state, {1.0, 179.0, true});
  const auto [a, b, t] = edge_on(mesh, 3);
  const int inner = mesh.state.vertices[a].carrier.dimension == 3 ? a : b;
  ASSERT_EQ(mesh.state.vertices[inner].carrier.dimension, 3);
  const int before = mesh.state.complex.tet_count();
  EXPECT_FALSE(collapse_edge(mesh.state, inner, a + b - inner, score, 0.99));
  EXPECT_EQ(mesh.state.complex.tet_count(), before);
  EXPECT_EQ(test::find_fault(mesh.state, mesh.solid), "");
}

TEST(CollapseEdge, KeepsTheBoundaryCloseToTheTrueOne) {
  constexpr double kRadius = 1.0, kAllowed = 0.03;
  const test::BallSolid ball(kRadius);
  const test::FunctionField field = test::constant(0.5);
  MeshState state(ball, field, 0.1, 3.5);
  state.chord_limit = 1.0;
  RunControl control;
  make_initial_mesh(state, ball.samples(), {0.25, 0.01}, control);
  for (Vertex& vertex : state.vertices) vertex.size = 10.0;
  state.chord_limit = kAllowed;
  const TetScore score(state, {1.0, 179.0, false});
  int collapses = 0;
  for (int v = 0; v < state.complex.vertex_slots(); ++v) {
    if (state.complex.tet_at(v) < 0 || state.vertices[v].carrier.dimension != 2) continue;
    const std::array<int, 4> around = state.complex.tet(state.complex.tet_at(v)).vertex;
    collapses += std::any_of(around.begin(), around.end(),
                             [&](int w) { return w != v && collapse_edge(state, v, w, score, 0.0); });
  }
  EXPECT_GT(collapses, 50);
  EXPECT_EQ(test::find_fault(state, ball), "");
  for (int t = 0; t < state.complex.slots(); ++t) {
    const Tet& tet = state.complex.tet(t);
    for (int i = 0; i < 4 && tet.alive(); ++i) {
      if (!tet.label[i]) continue;
      Vec3 centre = Vec3::Zero();
      for (int k = 0; k < 3; ++k) centre += state.position(tet.vertex[kFaceVertices[i][k]]) / 3.0;
      EXPECT_LT(kRadius - centre.norm(), kAllowed);
    }
  }
}

TEST(ResolveBoundary, SplitsEdgesThatAreFarFromTheTrueFace) {
  constexpr double kRadius = 1.0, kAllowed = 0.02;
  const test::BallSolid ball(kRadius);
  const test::FunctionField field = test::constant(0.5);
  MeshState state(ball, field, 0.1, 3.5);
  state.chord_limit = 1.0;
  RunControl control;
  make_initial_mesh(state, ball.samples(), {0.6, 0.1}, control);
  const double before = test::volume_of(state);
  for (Vertex& vertex : state.vertices) vertex.size = 10.0;
  const auto far_edges = [&] {
    std::vector<std::array<int, 3>> found;  // the ends, and a tetrahedron that has them
    for (int t = 0; t < state.complex.slots(); ++t) {
      const Tet& tet = state.complex.tet(t);
      for (int e = 0; e < 6 && tet.alive(); ++e) {
        if (!tet.label[kEdgeVertices[5 - e][0]])
          continue;  // one of the two tetrahedra with facets at the edge
        const int a = tet.vertex[kEdgeVertices[e][0]], b = tet.vertex[kEdgeVertices[e][1]];
        const double sagitta = kRadius - (0.5 * (state.position(a) + state.position(b))).norm();
        if (sagitta > 1.05 * kAllowed) found.push_back({a, b, t});
      }
    }
    return found;
  };
  const std::size_t far_before = far_edges().size();
  ASSERT_GT(far_before, 50u);
  state.chord_limit = kAllowed;
  EXPECT_GT(resolve_boundary(state, control), 0);
  EXPECT_EQ(test::find_fault(state, ball), "");
  EXPECT_GT(test::volume_of(state), before);
  EXPECT_LT(test::volume_of(state), ball.volume());
  // What is left is what cannot be split as the mesh stands.
  const auto left = far_edges();
  EXPECT_LT(left.size(), far_before / 10);
  for (const auto& [a, b, t] : left) EXPECT_EQ(split_edge(state, a, b, t), -1);
}

}  // namespace
}  // namespace fgmesh
