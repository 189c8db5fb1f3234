// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "core/error.hpp"
#include "material/material.hpp"
#include "occt_shapes.hpp"
#include "pipeline/generate_mesh.hpp"
#include "pipeline/volumes.hpp"
#include "quality/validity.hpp"

namespace fgmesh {
namespace {

constexpr double kPi = 3.14159265358979323846;

MeshingOptions with(double threshold, const std::string& stop_after = "geometry") {
  MeshingOptions options;
  options.material_threshold = threshold;
  options.stop_after = stop_after;
  return options;
}

MeshingResult meshed(const std::string& shape, const std::string& formula, const MeshingOptions& options) {
  RunControl control;
  return generate_mesh(shape, Material({formula}), options, control);
}

void expect_complete(const MeshingResult& result) {
  EXPECT_EQ(find_fault(result.mesh), "");
  EXPECT_EQ(result.fractions.size(), 2 * result.mesh.points.size());
  EXPECT_EQ(result.variation.size(), result.mesh.tets.size());
  EXPECT_EQ(result.dihedral_min.size(), result.mesh.tets.size());
  EXPECT_GT(result.peak_memory_mb, 1.0);
  ASSERT_FALSE(result.stages.empty());
  const StageReport& last = result.stages.back();
  EXPECT_EQ(last.points, result.mesh.points.size());
  EXPECT_EQ(last.tets, result.mesh.tets.size());
  EXPECT_EQ(last.facets, result.mesh.triangles.size());
  EXPECT_EQ(last.above_threshold, result.above_threshold.size());
}

TEST(GenerateMesh, OfABoxKeepsTheThreshold) {
  const MeshingResult result = meshed(test::box_text(10, 20, 5), "x/10", with(0.2));
  expect_complete(result);
  EXPECT_EQ(result.status, "ok");
  ASSERT_EQ(result.stages.size(), 3u);
  EXPECT_EQ(result.stages[0].name, "initial");
  EXPECT_EQ(result.stages[1].name, "material");
  EXPECT_EQ(result.stages[2].name, "geometry");
  EXPECT_LE(*std::max_element(result.variation.begin(), result.variation.end()), 0.2);
  EXPECT_NEAR(result.volume, 1000.0, 1e-9);
  EXPECT_NEAR(result.shape_volume, 1000.0, 1e-9);
  EXPECT_NEAR(result.deviation_max, 0.0, 1e-9);
  std::set<int> corners, edges, faces(result.mesh.triangle_faces.begin(), result.mesh.triangle_faces.end());
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    const Carrier& carrier = result.mesh.carriers[v];
    if (carrier.dimension == 0) corners.insert(carrier.number);
    if (carrier.dimension == 1) edges.insert(carrier.number);
    EXPECT_NEAR(result.fractions[2 * v], result.mesh.points[v].x() / 10.0, 1e-12);
  }
  EXPECT_EQ(corners.size(), 8u);
  EXPECT_EQ(edges.size(), 12u);
  EXPECT_EQ(faces.size(), 6u);
}

TEST(GenerateMesh, OfACylinderLiesOnTheTrueSurface) {
  constexpr double kRadius = 10.0, kHeight = 15.0;
  MeshingOptions options = with(0.2);
  options.surface_deviation = 0.02;
  const MeshingResult result = meshed(test::cylinder_text(kRadius, kHeight), "(z/15)^2", options);
  expect_complete(result);
  EXPECT_EQ(result.status, "ok");
  EXPECT_LE(result.deviation_max, 0.02);
  EXPECT_EQ(result.surface_deviation, 0.02);
  const double volume = kPi * kRadius * kRadius * kHeight;
  EXPECT_NEAR(result.shape_volume, volume, 1e-6 * volume);
  EXPECT_LT(result.volume, volume);
  EXPECT_NEAR(result.volume, volume, 0.005 * volume);
  std::vector<char> on_boundary(result.mesh.points.size(), 0);
  for (const auto& triangle : result.mesh.triangles)
    for (const int v : triangle) on_boundary[v] = 1;
  for (std::size_t v = 0; v < result.mesh.points.size(); ++v) {
    const Vec3& p = result.mesh.points[v];
    const double side = std::abs(std::hypot(p.x(), p.y()) - kRadius);
    const double end = std::min(std::abs(p.z()), std::abs(p.z() - kHeight));
    if (on_boundary[v]) {
      EXPECT_LT(std::min(side, end), 1e-7);
    } else {
      EXPECT_EQ(result.mesh.carriers[v].dimension, 3);
    }
  }
}

TEST(GenerateMesh, OfSecondOrderIsTheStraightMeshWithMoreNodes) {
  MeshingOptions options = with(0.2);
  options.surface_deviation = 0.1;
  const std::string cylinder = test::cylinder_text(10.0, 15.0);
  const MeshingResult first = meshed(cylinder, "(z/15)^2", options);
  options.order = 2;
  const MeshingResult second = meshed(cylinder, "(z/15)^2", options);
  EXPECT_TRUE(first.second_order.tets.empty());
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.tets, second.mesh.tets);
  EXPECT_EQ(first.variation, second.variation);
  EXPECT_EQ(first.dihedral_min, second.dihedral_min);
  const SecondOrderMesh& mesh = second.second_order;
  ASSERT_EQ(mesh.tets.size(), second.mesh.tets.size());
  ASSERT_EQ(second.fractions.size(), 2 * mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    EXPECT_NEAR(second.fractions[2 * v], std::pow(mesh.points[v].z() / 15.0, 2), 1e-9);
  EXPECT_LT(second.deviation_max, 0.1 * first.deviation_max);
  EXPECT_LT(std::abs(second.volume - second.shape_volume),
            0.01 * std::abs(first.volume - first.shape_volume));
}

TEST(GenerateMesh, OfSecondOrderRefusesAMaterialThatLeavesItsRangeInTheMiddleOfAnEdge) {
  // A peak above 1 so narrow that no corner of the coarse mesh is on it, but the middle of an edge may be.
  MeshingOptions options = with(0.5, "initial");
  const std::string box = test::box_text(10, 10, 10);
  options.max_size = 20.0;
  const MeshingResult coarse = meshed(box, "0.5", options);
  const auto& tet = coarse.mesh.tets[0];
  const Vec3 p = 0.5 * (coarse.mesh.points[tet[0]] + coarse.mesh.points[tet[1]]);
  std::ostringstream formula;
  formula.precision(17);
  formula << "0.5 + exp(-1000*((x - " << p.x() << ")^2 + (y - " << p.y() << ")^2 + (z - " << p.z() << ")^2))";
  EXPECT_NO_THROW(meshed(box, formula.str(), options));
  options.order = 2;
  try {
    meshed(box, formula.str(), options);
    ADD_FAILURE() << formula.str() << " went through";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("outside [0, 1]"), std::string::npos) << error.what();
  }
}

TEST(ExplainedVolumes, AreNotThoseOfAMeshThatLostAPart) {
  const std::string shape = test::cylinder_text(5, 10);
  RunControl control;
  BrepModel model = BrepModel::from_text(shape, control);
  model.sample({}, control);
  MeshingResult result = meshed(shape, "0.5", with(0.5));
  EXPECT_NO_THROW(require_explained_volumes(result, facet_deviations(result, model), model));
  const std::size_t lost = result.mesh.tets.size() / 20;
  result.mesh.tets.resize(result.mesh.tets.size() - lost);
  EXPECT_THROW(require_explained_volumes(result, facet_deviations(result, model), model), GeometryError);
}

TEST(GenerateMesh, StopsAfterTheStageAskedFor) {
  const std::string box = test::box_text(10, 10, 10);
  const MeshingResult initial = meshed(box, "x/10", with(0.1, "initial"));
  const MeshingResult material = meshed(box, "x/10", with(0.1, "material"));
  expect_complete(initial);
  expect_complete(material);
  EXPECT_EQ(initial.stages.size(), 1u);
  EXPECT_EQ(material.stages.size(), 2u);
  EXPECT_EQ(material.stages[0].tets, initial.stages[0].tets);
  EXPECT_FALSE(initial.above_threshold.empty()) << "its tetrahedra know nothing of the material";
  EXPECT_EQ(initial.status, "ok") << "and nobody asked that they should";
}

TEST(GenerateMesh, GivesTheSameMeshEachTime) {
  const std::string ball = test::ball_text(10.0);
  const MeshingResult first = meshed(ball, "exp(-0.1*d)", with(0.2)),
                      second = meshed(ball, "exp(-0.1*d)", with(0.2));
  EXPECT_EQ(first.mesh.points, second.mesh.points);
  EXPECT_EQ(first.mesh.tets, second.mesh.tets);
  EXPECT_EQ(first.mesh.triangles, second.mesh.triangles);
  EXPECT_EQ(first.fractions, second.fractions);
}

TEST(GenerateMesh, TellsWhereAJumpIs) {
  const MeshingResult result = meshed(test::box_text(10, 10, 10), "step(4.4, x)", with(0.1));
  expect_complete(result);
  EXPECT_EQ(result.status, "threshold_not_met");
  ASSERT_FALSE(result.messages.empty());
  const std::string& message = result.messages.back();
  EXPECT_NE(message.find("jumps"), std::string::npos) << message;
  EXPECT_NE(message.find(std::to_string(result.above_threshold.size()) + " of "), std::string::npos)
      << message;
  const std::set<int> above(result.above_threshold.begin(), result.above_threshold.end());
  for (std::size_t t = 0; t < result.mesh.tets.size(); ++t) {
    double low = 10.0, high = 0.0;
    for (const int v : result.mesh.tets[t]) {
      low = std::min(low, result.mesh.points[v].x());
      high = std::max(high, result.mesh.points[v].x());
    }
    EXPECT_EQ(above.count(static_cast<int>(t)) > 0, low < 4.4 && high >= 4.4);
  }
}

TEST(GenerateMesh, TellsThatTheSmallestSizeWasReached) {
  MeshingOptions options = with(0.01);
  options.min_size = 1.0;
  const MeshingResult result = meshed(test::box_text(10, 10, 10), "x/10", options);
  expect_complete(result);
  EXPECT_EQ(result.status, "threshold_not_met");
  ASSERT_FALSE(result.messages.empty());
  EXPECT_NE(result.messages.back().find("MinSize"), std::string::npos) << result.messages.back();
  double shortest = 10.0;
  for (const auto& [a, b, c, d] : result.mesh.tets) {
    for (const auto& [p, q] : {std::pair{a, b}, {a, c}, {a, d}, {b, c}, {b, d}, {c, d}})
      shortest = std::min(shortest, (result.mesh.points[p] - result.mesh.points[q]).norm());
  }
  EXPECT_GE(shortest, options.min_size);
}

TEST(GenerateMesh, RefusesAMaterialThatLeavesItsRangeAndNamesThePoint) {
  for (const char* formula : {"x/5", "x/10 - 0.5", "sqrt(x - 5)", "1/(x - 20)"}) {
    try {
      meshed(test::box_text(10, 10, 10), formula, with(0.3));
      ADD_FAILURE() << formula << " went through";
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find("at the point ("), std::string::npos) << error.what();
    }
  }
}

TEST(GenerateMesh, TakesAMaterialThatIsOutOfRangeOutsideTheSolidOnly) {
  // d/10 is above 1 nowhere in the ball, but rounding and chords come close to it from both sides.
  const MeshingResult result = meshed(test::ball_text(10.0), "d/10", with(0.25));
  EXPECT_EQ(result.status, "ok");
  EXPECT_EQ(find_fault(result.mesh), "");
  EXPECT_LE(*std::max_element(result.fractions.begin(), result.fractions.end()), 1.0);
}

TEST(GenerateMesh, RefusesBadOptionsAndShapesBeforeAllElse) {
  const std::string box = test::box_text(1, 1, 1);
  EXPECT_THROW(meshed(box, "x", with(0.0)), InvalidInput);
  EXPECT_THROW(meshed(box, "x", with(0.1, "nothing")), InvalidInput);
  EXPECT_THROW(meshed("", "x", with(0.1)), InvalidInput);
  EXPECT_THROW(meshed("no shape at all", "x", with(0.1)), InvalidInput);
  EXPECT_THROW(meshed(box.substr(0, box.size() / 2), "x", with(0.1)), InvalidInput);
}

}  // namespace
}  // namespace fgmesh
