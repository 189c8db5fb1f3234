// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/initial.hpp"
#include "mesh_checks.hpp"

namespace fgmesh {
namespace {

const test::FunctionField kField = test::constant(0.5);

struct Part {
  std::string name;
  std::shared_ptr<test::AnalyticSolid> solid;
  int faces, corners;
};

void PrintTo(const Part& part, std::ostream* stream) { *stream << part.name; }

std::vector<Part> parts() {
  return {{"Box", std::make_shared<test::BoxSolid>(Box{Vec3(-10, 0, 5), Vec3(20, 15, 15)}), 6, 8},
          {"Ball", std::make_shared<test::BallSolid>(10.0), 1, 0},
          {"Cylinder", std::make_shared<test::CylinderSolid>(5.0, 20.0), 3, 0}};
}

class InitialMesh : public testing::TestWithParam<Part> {
 protected:
  const test::AnalyticSolid& solid = *GetParam().solid;
  const SampledBoundary samples = solid.samples();
  const double diagonal = samples.bounds.diagonal();
  const InitialMeshOptions options = {diagonal / 10.0, diagonal / 200.0};

  MeshState made() {
    MeshState state(solid, kField, 0.1, diagonal);
    state.chord_limit = options.deviation;
    RunControl control;
    make_initial_mesh(state, samples, options, control);
    return state;
  }
};

TEST_P(InitialMesh, IsASoundMeshOfTheTrueSolid) {
  const MeshState state = made();
  // Eight chords of a circle are 2.6 % shorter than it.
  EXPECT_EQ(test::find_fault(state, solid, 0.026), "");
  EXPECT_NEAR(test::volume_of(state), solid.volume(), 0.05 * solid.volume());
  EXPECT_GT(test::angle_range(state).smallest, 1.0);
  const TetMesh mesh = state.to_tet_mesh();
  std::vector<int> facets(GetParam().faces + 1, 0);
  int corners = 0;
  for (const int face : mesh.triangle_faces) ++facets.at(face);
  for (const Carrier& carrier : mesh.carriers) corners += carrier.dimension == 0;
  for (int face = 1; face <= GetParam().faces; ++face) EXPECT_GT(facets[face], 0) << "face " << face;
  EXPECT_EQ(corners, GetParam().corners);
}

TEST_P(InitialMesh, IsTheSameEachTime) {
  const TetMesh first = made().to_tet_mesh(), second = made().to_tet_mesh();
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.tets, second.tets);
  EXPECT_EQ(first.triangle_faces, second.triangle_faces);
}

TEST_P(InitialMesh, IsFinerWhereASmallerSizeIsAsked) {
  MeshState fine(solid, kField, 0.1, diagonal);
  fine.chord_limit = options.deviation;
  RunControl control;
  make_initial_mesh(fine, samples, {0.5 * options.size, options.deviation}, control);
  EXPECT_GT(fine.complex.tet_count(), 2 * made().complex.tet_count());
}

TEST_P(InitialMesh, StopsWhenCancelled) {
  MeshState state(solid, kField, 0.1, diagonal);
  RunControl control;
  control.cancel();
  EXPECT_THROW(make_initial_mesh(state, samples, options, control), Cancelled);
}

INSTANTIATE_TEST_SUITE_P(Of, InitialMesh, testing::ValuesIn(parts()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace fgmesh
