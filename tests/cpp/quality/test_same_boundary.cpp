// SPDX-License-Identifier: GPL-3.0-or-later
// A coarse grid of a box stands for the shape's samples, a finer one for its mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "box_grid.hpp"
#include "quality/same_boundary.hpp"

namespace fgmesh {
namespace {

SampledBoundary samples_of(const TetMesh& mesh) {
  SampledBoundary samples;
  samples.points = mesh.points;
  samples.triangles.assign(mesh.triangles.begin(), mesh.triangles.end());
  samples.triangle_face.assign(mesh.triangle_faces.begin(), mesh.triangle_faces.end());
  samples.face_count = *std::max_element(mesh.triangle_faces.begin(), mesh.triangle_faces.end());
  std::map<int, std::vector<std::array<int, 2>>> segments;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) segments[mesh.edge_edges[i]].push_back(mesh.edges[i]);
  for (const auto& [edge, own] : segments) {
    std::vector<int> points(own.front().begin(), own.front().end());
    for (const auto& [a, b] : own) points.insert(points.end(), {a, b});
    const auto along = [&](int a, int b) {  // the edges of a box are parallel to axes
      const Vec3 &p = mesh.points[a], &q = mesh.points[b];
      return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    std::sort(points.begin(), points.end(), along);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    samples.curves.push_back({edge, points, {}, {}});
  }
  return samples;
}

std::string difference(const TetMesh& mesh, const SampledBoundary& samples,
                       const std::vector<Carrier>& bridged = {}) {
  return find_difference(mesh, samples, bridged, [](const Carrier& part) {
    return (part.dimension == 2 ? "Face" : "Edge") + std::to_string(part.number);
  });
}

/// Index of a triangle in the middle of FaceN: no vertex on an edge.
std::size_t inner_triangle(const TetMesh& mesh, int face) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.triangle_faces[t] == face && std::all_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
                                                      [&](int v) { return mesh.carriers[v].dimension == 2; }))
      return t;
  ADD_FAILURE() << "no such triangle";
  return 0;
}

template <class Element, class Number>
void erase_all(std::vector<Element>& elements, std::vector<Number>& numbers, Number number) {
  for (std::size_t i = elements.size(); i-- > 0;) {
    if (numbers[i] != number) continue;
    elements.erase(elements.begin() + i);
    numbers.erase(numbers.begin() + i);
  }
}

struct Plant {
  std::string name;
  std::function<void(TetMesh&)> change;
  std::string told;
};

void PrintTo(const Plant& plant, std::ostream* stream) { *stream << plant.name; }

std::vector<Plant> plants() {
  return {
      {"LostFace", [](TetMesh& m) { erase_all(m.triangles, m.triangle_faces, 3); }, "Face3 has no elements"},
      {"FaceWithAHole",
       [](TetMesh& m) {
         const std::size_t t = inner_triangle(m, 4);
         m.triangles.erase(m.triangles.begin() + t);
         m.triangle_faces.erase(m.triangle_faces.begin() + t);
       },
       "Face4 has other holes"},
      {"PieceOfAnotherFace", [](TetMesh& m) { m.triangle_faces[inner_triangle(m, 6)] = 5; },
       "Face5 is in 2 pieces where the shape has 1"},
      {"LostEdge", [](TetMesh& m) { erase_all(m.edges, m.edge_edges, 2); }, "Edge2 has no elements"},
      {"ClosedEdge",
       [](TetMesh& m) {
         std::map<int, int> uses;
         for (std::size_t i = 0; i < m.edges.size(); ++i)
           for (int v : m.edges[i]) uses[v] += m.edge_edges[i] == 4;
         std::vector<int> ends;
         for (const auto& [v, count] : uses)
           if (count == 1) ends.push_back(v);
         m.edges.push_back({ends.at(0), ends.at(1)});
         m.edge_edges.push_back(4);
       },
       "Edge4 has other holes"},
      {"WallWithoutThickness",
       [](TetMesh& m) {
         const auto from = m.triangles[inner_triangle(m, 3)], to = m.triangles[inner_triangle(m, 4)];
         for (auto& triangle : m.triangles)
           for (int& v : triangle)
             for (int i : {0, 1})
               if (v == from[i]) v = to[i];
       },
       "Face3 and Face4 touch"},
  };
}

class SameBoundary : public testing::TestWithParam<Plant> {};

TEST_P(SameBoundary, FindsThePlantedDifference) {
  const SampledBoundary samples = samples_of(test::box_grid(1.0, 2));
  TetMesh mesh = test::box_grid(1.0, 5);
  ASSERT_EQ(difference(mesh, samples), "");
  GetParam().change(mesh);
  EXPECT_NE(difference(mesh, samples).find(GetParam().told), std::string::npos) << difference(mesh, samples);
}

INSTANTIATE_TEST_SUITE_P(Difference, SameBoundary, testing::ValuesIn(plants()),
                         [](const auto& info) { return info.param.name; });

TEST(SameBoundaryOfTwoSolids, CountsTheInterface) {
  const SampledBoundary samples = samples_of(test::box_grid(1.0, 2, 2));
  TetMesh mesh = test::box_grid(1.0, 4, 2);
  EXPECT_EQ(difference(mesh, samples), "");
  erase_all(mesh.triangles, mesh.triangle_faces, 7);
  EXPECT_EQ(difference(mesh, samples), "Face7 has no elements");
  EXPECT_EQ(difference(mesh, samples, {{2, 7}}), "") << "which is no fault of a face that was bridged";
}

}  // namespace
}  // namespace fgmesh
