// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <gp_Trsf.hxx>

#include "brep_shapes.hpp"
#include "core/error.hpp"

// Shapes that break the rules without harm to their geometry are mended, and keep their numbers.
namespace fgmesh {
namespace {

/// A solid of the faces of `shape`, that of number `turned` turned over.
TopoDS_Solid with_turned_face(const TopoDS_Shape& shape, int turned) {
  const BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  int number = 0;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    builder.Add(shell, ++number == turned ? it.Current().Reversed() : it.Current());
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

/// Mean of the samples of each face.
std::vector<Vec3> face_centres(const SampledBoundary& boundary) {
  std::vector<Vec3> sums(boundary.face_count, Vec3::Zero());
  std::vector<int> counts(boundary.face_count, 0);
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i)
    for (const int v : boundary.triangles[i]) {
      sums[boundary.triangle_face[i] - 1] += boundary.points[v];
      ++counts[boundary.triangle_face[i] - 1];
    }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
  return sums;
}

class TurnedFace : public testing::TestWithParam<int> {};

TEST_P(TurnedFace, IsTurnedBackAndNumbersStay) {
  const TopoDS_Shape sound = test::box_with_hole();
  const auto [before, sound_samples] = test::sampled(sound);
  const auto [after, samples] = test::sampled(with_turned_face(sound, GetParam()));
  EXPECT_NEAR(after.volume(), 72000.0 - M_PI * 64.0 * 30.0, 1e-6);
  ASSERT_EQ(after.notes().size(), 1u);
  EXPECT_EQ(after.notes()[0].find("Face" + std::to_string(GetParam()) + " was turned"), 0u)
      << after.notes()[0];
  ASSERT_EQ(after.face_count(), before.face_count());
  ASSERT_EQ(after.edge_count(), before.edge_count());
  const std::vector<Vec3> expected = face_centres(sound_samples), found = face_centres(samples);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_LT((found[i] - expected[i]).norm(), 1e-9);
  for (int edge = 1; edge <= before.edge_count(); ++edge)
    EXPECT_LT(
        (after.project_to_edge(edge, {1, 2, 3}).position - before.project_to_edge(edge, {1, 2, 3}).position)
            .norm(),
        1e-9);
}

INSTANTIATE_TEST_SUITE_P(Healing, TurnedFace, testing::Range(1, 8));

TEST(Healing, FlagsThatSayEdgesRunDifferentlyAreChecked) {
  const TopoDS_Shape shape = test::box_with_hole();
  const BRep_Builder builder;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    builder.SameParameter(TopoDS::Edge(it.Current()), Standard_False);
    builder.SameRange(TopoDS::Edge(it.Current()), Standard_False);
  }
  const auto [model, boundary] = test::sampled(shape);
  EXPECT_NEAR(model.volume(), 72000.0 - M_PI * 64.0 * 30.0, 1e-6);
  ASSERT_FALSE(model.notes().empty());
  EXPECT_NE(model.notes()[0].find("runs differently in space and on its faces; that was mended"),
            std::string::npos)
      << model.notes()[0];
}

TEST(Healing, SolidsInACompoundKeepTheirNumbers) {
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(500, 0, 0));
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  builder.Add(compound, test::box(1, 2, 3));
  builder.Add(compound, with_turned_face(test::box(10, 20, 30), 4).Moved(TopLoc_Location(shift)));
  const BrepModel model = test::read(compound);
  EXPECT_EQ(model.solid_count(), 2);
  EXPECT_EQ(model.face_count(), 12);
  EXPECT_NEAR(model.volume(), 6.0 + 6000.0, 1e-6);
  ASSERT_FALSE(model.notes().empty());
  EXPECT_EQ(model.notes()[0].find("Face10 was turned"), 0u) << model.notes()[0];
}

TEST(Healing, WhatWouldMoveTheGeometryIsRefused) {
  // A vertex a thousandth of the part off, with a tolerance that denies it.
  const TopoDS_Shape shape = test::box(10, 10, 10);
  const TopoDS_Vertex vertex = TopoDS::Vertex(TopExp_Explorer(shape, TopAbs_VERTEX).Current());
  gp_Pnt position = BRep_Tool::Pnt(vertex);
  position.SetX(position.X() + 0.01);
  BRep_Builder().UpdateVertex(vertex, position, 1e-7);
  RunControl control;
  try {
    BrepModel::from_text(test::brep_text(shape), control);
    FAIL() << "not refused";
  } catch (const GeometryError& error) {
    EXPECT_EQ(std::string(error.what()).find("Vertex1 lies farther"), 0u) << error.what();
  }
}

}  // namespace
}  // namespace fgmesh
