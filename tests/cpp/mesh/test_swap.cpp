// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "mesh/swap_pass.hpp"
#include "mesh_checks.hpp"
#include "quality/mesh_statistics.hpp"
#include "quality/validity.hpp"

namespace fgmesh {
namespace {

double energy_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  double squared = 0.0;
  const std::vector<Vec3> p = {a, b, c, d};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) squared += (p[i] - p[j]).squaredNorm();
  return std::abs((b - a).cross(c - a).dot(d - a)) * squared;
}

double energy_of(const MeshState& state) {
  double sum = 0.0;
  for (const auto& [a, b, c, d] : state.to_tet_mesh().tets)
    sum += energy_of(state.position(a), state.position(b), state.position(c), state.position(d));
  return sum;
}

/// The least energy that any mesh of these points has: that of CGAL's Delaunay triangulation.
double least_energy(const MeshState& state) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Delaunay_triangulation_3<Kernel> delaunay;
  for (const Vec3& p : state.to_tet_mesh().points) delaunay.insert({p.x(), p.y(), p.z()});
  double sum = 0.0;
  for (auto cell = delaunay.finite_cells_begin(); cell != delaunay.finite_cells_end(); ++cell) {
    std::vector<Vec3> p;
    for (int i = 0; i < 4; ++i) {
      const auto& place = cell->vertex(i)->point();
      p.emplace_back(place.x(), place.y(), place.z());
    }
    sum += energy_of(p[0], p[1], p[2], p[3]);
  }
  return sum;
}

class OdtSwaps : public testing::TestWithParam<unsigned> {};

TEST_P(OdtSwaps, LowerTheEnergyUntilTheMeshIsDelaunay) {
  RunControl control;
  test::GridMesh mesh(2.0, 4);
  mesh.shake(0.3, GetParam());
  const OdtEnergy objective(mesh.state);
  double energy = energy_of(mesh.state);
  const double least = least_energy(mesh.state);
  ASSERT_GT(energy, 1.001 * least) << "already Delaunay: nothing is tested";
  for (int pass = 0; pass < 30; ++pass) {
    const int swaps = swap_pass(mesh.state, objective, control);
    const double after = energy_of(mesh.state);
    EXPECT_LE(after, energy * (1.0 + 1e-12));
    ASSERT_EQ(test::find_fault(mesh.state, mesh.solid), "");
    ASSERT_NEAR(test::volume_of(mesh.state), 8.0, 1e-11);
    energy = after;
    if (swaps == 0) break;
  }
  EXPECT_NEAR(energy, least, 1e-4 * least);
}

INSTANTIATE_TEST_SUITE_P(Seed, OdtSwaps, testing::Range(1u, 7u));

TEST(Swapper, DoesNotTouchWhatIsDelaunay) {
  RunControl control;
  test::GridMesh mesh(2.0, 3);
  mesh.shake(0.3, 3);
  const OdtEnergy objective(mesh.state);
  while (swap_pass(mesh.state, objective, control) > 0) continue;
  const auto before = mesh.state.to_tet_mesh().tets;
  EXPECT_EQ(swap_pass(mesh.state, objective, control), 0);
  EXPECT_EQ(mesh.state.to_tet_mesh().tets, before);
}

TEST(Swapper, MakesNothingThatVariesMoreThanAllowed) {
  RunControl control;
  constexpr double kMost = 0.35;
  test::GridMesh mesh(2.0, 4, test::linear(Vec3(0.5, 0, 0)), kMost);
  mesh.shake(0.15, 5);
  ASSERT_LT(test::largest_variation(mesh.state), kMost) << "nothing may be above at the start";
  const OdtEnergy free(mesh.state), bounded(mesh.state, kMost);
  int swaps = 0;
  for (int pass = 0; pass < 10; ++pass) swaps += swap_pass(mesh.state, bounded, control);
  EXPECT_GT(swaps, 0);
  EXPECT_LE(test::largest_variation(mesh.state), kMost);
}

/// A box of two solids with the interface of box_grid(), whose vertices know that they are on it.
class TwoBoxes final : public test::BoxSolid {
 public:
  TwoBoxes() : test::BoxSolid({Vec3::Zero(), Vec3::Constant(2.0)}) {}
  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess = nullptr) const override {
    if (face != 7) return test::BoxSolid::project_to_face(face, p, guess);
    SurfacePoint found;
    found.position = Vec3(1.0, p.y(), p.z());
    found.normal = Vec3::UnitX();
    return found;
  }
};

void carry_interface(MeshState& state) {
  for (Vertex& vertex : state.vertices)
    if (vertex.carrier.dimension == 3 && vertex.position.x() == 1.0) {
      vertex.carrier = {2, 7};
      vertex.direction = Vec3::UnitX();
    }
}

/// Moves inner vertices, and those on the interface along it, where no tetrahedron is turned over.
void shake(MeshState& state, double most, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-most, most);
  std::vector<int> star;
  for (int v = 0; v < state.complex.vertex_slots(); ++v) {
    Vertex& vertex = state.vertices[v];
    Vec3 way(offset(random), offset(random), offset(random));
    const bool inner = vertex.carrier.dimension == 3, on_interface = vertex.carrier.number == 7;
    if (!inner && !(vertex.carrier.dimension == 2 && on_interface)) continue;
    if (!inner) way.x() = 0.0;
    state.complex.star(v, star);
    if (stays_positive(state, v, vertex.position + way, star)) vertex.position += way;
  }
}

std::set<std::array<int, 3>> interface_triangles(const TetMesh& mesh) {
  std::set<std::array<int, 3>> found;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::array<int, 3> corners = mesh.triangles[f];
    std::sort(corners.begin(), corners.end());
    if (mesh.triangle_faces[f] == 7) found.insert(corners);
  }
  return found;
}

class SwapsAtAnInterface : public testing::TestWithParam<unsigned> {};

TEST_P(SwapsAtAnInterface, KeepItAndTheSolidsAndLowerTheEnergy) {
  RunControl control;
  const TwoBoxes solid;
  const test::FunctionField field = test::constant(0.5);
  MeshState state(solid, field, 0.1, 3.0);
  const TetMesh grid = test::box_grid(2.0, 4, 2);
  test::load(state, grid, 0.5);
  state.chord_limit = 1e-9;
  carry_interface(state);
  if (GetParam() > 0) shake(state, 0.15, GetParam());
  const auto before = interface_triangles(state.to_tet_mesh());
  const OdtEnergy objective(state);
  double energy = energy_of(state);
  for (int pass = 0; pass < 6; ++pass) {
    swap_pass(state, objective, control);
    ASSERT_EQ(test::find_fault(state, solid), "");
    EXPECT_LE(energy_of(state), energy * (1.0 + 1e-12));
    energy = energy_of(state);
  }
  const TetMesh after = state.to_tet_mesh();
  EXPECT_EQ(after.edges.size(), grid.edges.size());
  double area = 0.0;
  for (const auto& [a, b, c] : interface_triangles(after)) {
    area += 0.5 * area_vector(after.points[a], after.points[b], after.points[c]).norm();
    for (const int v : {a, b, c}) EXPECT_EQ(after.points[v].x(), 1.0);
  }
  EXPECT_NEAR(area, 4.0, 1e-12);
  const std::vector<double> volumes = tet_volumes(after);
  double first = 0.0;
  for (std::size_t t = 0; t < volumes.size(); ++t) first += after.tet_solids[t] == 1 ? volumes[t] : 0.0;
  EXPECT_NEAR(first, 4.0, 1e-12);
  if (GetParam() > 0) {
    EXPECT_NE(interface_triangles(after), before) << "no edge of the interface was swapped";
  }
}

INSTANTIATE_TEST_SUITE_P(Seed, SwapsAtAnInterface, testing::Range(0u, 5u));

/// Two pyramids of one solid each on a common rectangle in the plane x = 1, cut along the diagonal (0, 1).
TEST(Swapper, TakesTheShorterDiagonalOfAnInterface) {
  const TwoBoxes solid;
  const test::FunctionField field = test::constant(0.5);
  MeshState state(solid, field, 0.1, 3.0);
  state.chord_limit = 1e-9;
  const std::vector<Vec3> places = {{1, 0, 1}, {1, 2, 1}, {1, 1, 0.6}, {1, 1, 1.4}, {0.5, 1, 1}, {1.5, 1, 1}};
  for (const Vec3& place : places) {
    Vertex vertex;
    vertex.position = place;
    state.vertices.push_back(vertex);
  }
  carry_interface(state);
  std::vector<NewTet> tets = {{{0, 1, 2, 4}, 1}, {{0, 1, 3, 4}, 1}, {{0, 1, 2, 5}, 2}, {{0, 1, 3, 5}, 2}};
  for (NewTet& tet : tets) {
    const auto& [a, b, c, d] = tet.vertex;
    if (orientation(places[a], places[b], places[c], places[d]) < 0.0)
      std::swap(tet.vertex[0], tet.vertex[1]);
  }
  std::vector<LabelledFacet> facets = {{{0, 1, 2}, 7}, {{0, 1, 3}, 7}};
  for (int apex : {4, 5})
    for (const auto& [p, q] : {std::pair(0, 2), std::pair(2, 1), std::pair(1, 3), std::pair(3, 0)})
      facets.push_back({{p, q, apex}, 1});
  state.complex.build(tets, facets, 6);

  const OdtEnergy objective(state);
  Swapper swapper(state, objective);
  ASSERT_TRUE(swapper.remove_edge(0, 1, state.complex.find_edge(0, 1)));
  const TetMesh after = state.to_tet_mesh();
  EXPECT_EQ(find_fault(after), "");
  EXPECT_EQ(interface_triangles(after), (std::set<std::array<int, 3>>{{0, 2, 3}, {1, 2, 3}}));
  for (std::size_t t = 0; t < after.tets.size(); ++t) {
    const auto& v = after.tets[t];
    EXPECT_EQ(std::find(v.begin(), v.end(), 4) != v.end(), after.tet_solids[t] == 1);
  }
  EXPECT_FALSE(swapper.remove_edge(2, 3, state.complex.find_edge(2, 3))) << "back to the longer one";
}

}  // namespace
}  // namespace fgmesh
