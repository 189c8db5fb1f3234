// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "fields.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {
namespace {

/// A vertex inside a solid of one material.
Vertex inner(int material, double value) {
  Vertex vertex;
  vertex.own = {material, {value}, {Vec3(Vec3::Zero())}};
  return vertex;
}

/// A vertex where materials 0 and 1 meet.
Vertex between(double value, double other) {
  Vertex vertex = inner(0, value);
  vertex.others.push_back({1, {other}, {Vec3(Vec3::Zero())}});
  return vertex;
}

TEST(VariationAtInterface, IsThatOfTheMaterialWhichAllVerticesHave) {
  const Vertex a = between(0.2, 0.9), b = between(0.3, 0.95);
  EXPECT_NEAR(variation(a, b, a, inner(0, 0.25)), 0.1, 1e-15);
  EXPECT_NEAR(variation(a, inner(1, 0.8), b, b), 0.15, 1e-15);
  EXPECT_NEAR(variation(inner(1, 0.1), a, b, a), 0.85, 1e-15);
}

TEST(VariationAtInterface, NeverCountsTheJump) {
  const Vertex a = between(0.2, 0.9);
  EXPECT_EQ(variation(a, a, a, a), 0.0);
  EXPECT_EQ(variation(a, a, a, inner(0, 0.2)), 0.0);
  EXPECT_EQ(variation(a, a, a, inner(1, 0.9)), 0.0);
}

TEST(VariationAtInterface, IsTheWorstOneWhereAllVerticesAreOnIt) {
  const Vertex a = between(0.2, 0.9), b = between(0.25, 0.5);
  EXPECT_NEAR(variation(a, b, a, b), 0.4, 1e-15);
}

/// Two solids on the two sides of Face1, which Edge1 and Vertex1 bound; Face2 is of the first, Face3 of the
/// second alone.
SampledBoundary two_solids() {
  SampledBoundary samples;
  samples.points = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(-1, 0, 0), Vec3(1, 0, 0)};
  samples.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 2}};
  samples.triangle_face = {1, 2, 3};
  samples.triangle_solids = {{1, 2}, {1, 0}, {2, 0}};
  samples.curves = {{1, {0, 2}, {0.0, 1.0}, {1, 2, 3}}};
  samples.corners = {{1, 0}};
  samples.solid_count = 2;
  samples.face_count = 3;
  return samples;
}

TEST(SolidMaterials, AreThoseOfTheSolidsThatMeet) {
  const test::FunctionField first = test::constant(0.2), second = test::constant(0.9);
  const SolidMaterials materials({&first, &second}, two_solids());
  EXPECT_EQ(materials.count(), 2);
  const std::vector<int> both = {0, 1}, one = {0}, other = {1};
  for (const Carrier& carrier : {Carrier{2, 1}, Carrier{1, 1}, Carrier{0, 1}})
    EXPECT_EQ(materials.at(carrier), both);
  EXPECT_EQ(materials.at({2, 2}), one);
  EXPECT_EQ(materials.at({2, 3}), other);
  EXPECT_EQ(materials.at({3, 1}), one);
  EXPECT_EQ(materials.at({3, 2}), other);
}

TEST(SolidMaterials, AreOneWhereTheSolidsHaveTheSame) {
  const test::FunctionField field = test::constant(0.2);
  const SolidMaterials materials({&field, &field}, two_solids());
  EXPECT_EQ(materials.count(), 1);
  EXPECT_EQ(materials.of_solid(2), 0);
}

}  // namespace
}  // namespace fgmesh
