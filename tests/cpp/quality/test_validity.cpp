// SPDX-License-Identifier: GPL-3.0-or-later
// Every fault is planted into a mesh that is right, and must be found.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "box_grid.hpp"
#include "quality/validity.hpp"

namespace fgmesh {
namespace {

struct Plant {
  std::string name;
  std::function<void(TetMesh&)> change;
  std::string told;  ///< part of the words that tell it
};

void PrintTo(const Plant& plant, std::ostream* stream) { *stream << plant.name; }

int inner_point(const TetMesh& mesh) {
  const auto found = std::find_if(mesh.carriers.begin(), mesh.carriers.end(),
                                  [](const Carrier& carrier) { return carrier.dimension == 3; });
  return static_cast<int>(found - mesh.carriers.begin());
}

/// A tetrahedron with no face on the boundary.
int inner_tet(const TetMesh& mesh) {
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (std::count_if(mesh.tets[t].begin(), mesh.tets[t].end(),
                      [&](int v) { return mesh.carriers[v].dimension == 3; }) >= 2)
      return static_cast<int>(t);
  ADD_FAILURE() << "no such tetrahedron";
  return 0;
}

/// The tetrahedra made of two, but not their neighbours, know of a new point half-way along an edge.
void plant_t_junction(TetMesh& mesh) {
  const int t = inner_tet(mesh);
  std::array<std::int32_t, 4> half = mesh.tets[t];
  const auto middle = static_cast<std::int32_t>(mesh.points.size());
  mesh.points.push_back(0.5 * (mesh.points[half[0]] + mesh.points[half[1]]));
  mesh.carriers.push_back({3, 1});
  mesh.tets[t][0] = middle;
  half[1] = middle;
  mesh.tets.push_back(half);
  mesh.tet_solids.push_back(1);
}

/// A second point where one stands, used by one tetrahedron.
void plant_duplicate_point(TetMesh& mesh) {
  const int v = inner_point(mesh);
  mesh.points.push_back(mesh.points[v]);
  mesh.carriers.push_back(mesh.carriers[v]);
  for (auto& tet : mesh.tets) {
    const auto corner = std::find(tet.begin(), tet.end(), v);
    if (corner == tet.end()) continue;
    *corner = static_cast<std::int32_t>(mesh.points.size() - 1);
    return;
  }
}

/// A third tetrahedron on a face that two share.
void plant_third_tet(TetMesh& mesh) {
  std::array<std::int32_t, 4> extra = mesh.tets[inner_tet(mesh)];
  extra[0] = static_cast<std::int32_t>(mesh.points.size());
  const auto& tet = mesh.tets[inner_tet(mesh)];
  mesh.points.push_back(mesh.points[tet[0]] + 1e-3 * (mesh.points[tet[1]] - mesh.points[tet[0]]));
  mesh.carriers.push_back({3, 1});
  mesh.tets.push_back(extra);
  mesh.tet_solids.push_back(1);
}

/// A labelled triangle that is an inner face.
void plant_inner_label(TetMesh& mesh) {
  const auto& tet = mesh.tets[inner_tet(mesh)];
  mesh.triangles.push_back({tet[1], tet[2], tet[3]});
  mesh.triangle_faces.push_back(1);
}

void plant_crossing_edge(TetMesh& mesh) {
  const auto far = static_cast<std::int32_t>(mesh.points.size() - 1);
  mesh.edges.push_back({0, far});
  mesh.edge_edges.push_back(1);
}

std::vector<Plant> plants() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      {"NoTets", [](TetMesh& m) { m = {}; }, "no tetrahedra"},
      {"FlippedTet", [](TetMesh& m) { std::swap(m.tets[7][0], m.tets[7][1]); }, "tetrahedron 7 "},
      {"FlatTet", [](TetMesh& m) { m.points[m.tets[0][0]] = m.points[m.tets[0][1]] + Vec3(1e-9, 0, 0); },
       "oriented"},
      {"DuplicatePoint", plant_duplicate_point, "coincide"},
      {"StrayPoint",
       [](TetMesh& m) {
         m.points.push_back(Vec3(9, 9, 9));
         m.carriers.push_back({3, 1});
       },
       "no tetrahedron"},
      {"NanPoint", [nan](TetMesh& m) { m.points[3].y() = nan; }, "finite"},
      {"IndexTooLarge", [](TetMesh& m) { m.tets[2][1] = static_cast<std::int32_t>(m.points.size()); },
       "does not exist"},
      {"NegativeIndex", [](TetMesh& m) { m.tets[2][1] = -1; }, "does not exist"},
      {"MissingLabel",
       [](TetMesh& m) {
         m.triangles.pop_back();
         m.triangle_faces.pop_back();
       },
       "1 boundary facets"},
      {"InwardLabel", [](TetMesh& m) { std::swap(m.triangles[5][0], m.triangles[5][2]); }, "inward"},
      {"DuplicateLabel",
       [](TetMesh& m) {
         m.triangles.push_back(m.triangles[5]);
         m.triangle_faces.push_back(m.triangle_faces[5]);
       },
       "twice"},
      {"DuplicateInwardLabel",
       [](TetMesh& m) {
         m.triangles.push_back({m.triangles[5][1], m.triangles[5][0], m.triangles[5][2]});
         m.triangle_faces.push_back(m.triangle_faces[5]);
       },
       "twice"},
      {"LabelInside", plant_inner_label, "inside"},
      {"OpenBoundary",
       [](TetMesh& m) {
         m.tets.erase(m.tets.begin() + inner_tet(m));
         m.tet_solids.pop_back();
       },
       "4 boundary facets"},
      {"TJunction", plant_t_junction, "boundary facets"},
      {"ThirdTetOnAFace", plant_third_tet, "3 tetrahedra"},
      {"TetTwice",
       [](TetMesh& m) {
         m.tets.push_back(m.tets[0]);
         m.tet_solids.push_back(1);
       },
       "tetrahedra"},
      {"SolidZero", [](TetMesh& m) { m.tet_solids[4] = 0; }, "no solid"},
      {"FaceZero", [](TetMesh& m) { m.triangle_faces[4] = 0; }, "no face"},
      {"TetWithoutSolid", [](TetMesh& m) { m.tet_solids.pop_back(); }, "solid"},
      {"TriangleWithoutFace", [](TetMesh& m) { m.triangle_faces.pop_back(); }, "face"},
      {"EdgeWithoutNumber", [](TetMesh& m) { m.edge_edges.pop_back(); }, "number"},
      {"PointWithoutCarrier", [](TetMesh& m) { m.carriers.pop_back(); }, "carrier"},
      {"SolidsWithoutInterface",
       [](TetMesh& m) {
         for (std::size_t t = 0; t < m.tets.size() / 2; ++t) m.tet_solids[t] = 2;
       },
       "between two solids"},
      {"EdgeThatIsNone", plant_crossing_edge, "edge"},
  };
}

class Validity : public testing::TestWithParam<Plant> {};

TEST_P(Validity, FindsThePlantedFault) {
  TetMesh mesh = test::box_grid(1.0, 3);
  ASSERT_EQ(find_fault(mesh), "");
  GetParam().change(mesh);
  const std::string fault = find_fault(mesh);
  EXPECT_NE(fault, "");
  EXPECT_NE(fault.find(GetParam().told), std::string::npos) << fault;
}

INSTANTIATE_TEST_SUITE_P(Fault, Validity, testing::ValuesIn(plants()),
                         [](const auto& info) { return info.param.name; });

TEST(ValidityOfSoundMeshes, FindsNothing) {
  EXPECT_EQ(find_fault(test::box_grid(1.0, 1)), "");
  EXPECT_EQ(find_fault(test::box_grid({Vec3(-1, 2, 3), Vec3(5, 9, 4)}, {2, 3, 1})), "");
  EXPECT_EQ(find_fault(test::box_grid(1e-6, 2)), "") << "nothing in it is an absolute length";
  EXPECT_EQ(find_fault(test::box_grid(1e6, 2)), "");
}

TEST(ValidityOfTwoSolids, WantsEachInterfaceFacetOnce) {
  TetMesh mesh = test::box_grid(1.0, 4, 2);
  ASSERT_EQ(find_fault(mesh), "");
  const auto interface = std::find(mesh.triangle_faces.begin(), mesh.triangle_faces.end(), 7);
  ASSERT_NE(interface, mesh.triangle_faces.end());
  mesh.triangles.erase(mesh.triangles.begin() + (interface - mesh.triangle_faces.begin()));
  mesh.triangle_faces.erase(interface);
  EXPECT_NE(find_fault(mesh).find("between two solids"), std::string::npos);
}

}  // namespace
}  // namespace fgmesh
