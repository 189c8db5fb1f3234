// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Pln.hxx>

#include "brep_shapes.hpp"
#include "core/error.hpp"

namespace fgmesh {
namespace {

/// Message of the error of kind `Kind`; fails where another or none is thrown.
template <class Kind>
std::string refusal(const std::string& text) {
  RunControl control;
  try {
    BrepModel::from_text(text, control);
  } catch (const Kind& error) {
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "another kind of error: " << error.what();
    return {};
  }
  ADD_FAILURE() << "not refused";
  return {};
}

#define EXPECT_SAYS(message, words) EXPECT_NE((message).find(words), std::string::npos) << (message)

/// Faces of `shape` but the last `left_out`, as one shell.
TopoDS_Shell shell_of(const TopoDS_Shape& shape, int left_out) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  for (std::size_t i = 0; i + left_out < faces.size(); ++i) builder.Add(shell, faces[i]);
  return shell;
}

TopoDS_Solid solid_of(const TopoDS_Shell& shell) {
  TopoDS_Solid solid;
  const BRep_Builder builder;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

TEST(Refusal, Empty) {
  EXPECT_SAYS(refusal<InvalidInput>(""), "empty");
  EXPECT_SAYS(refusal<InvalidInput>(" \n\t\n"), "empty");
}

TEST(Refusal, OtherData) {
  EXPECT_SAYS(refusal<InvalidInput>("solid ascii stl\nfacet normal 0 0 1\n"), "neither BREP nor STEP");
  EXPECT_SAYS(refusal<InvalidInput>(std::string("\x01\x02\0\x03", 4)), "binary");
  EXPECT_SAYS(refusal<InvalidInput>("PK\x03\x04 rest of an archive"), "zip");
  EXPECT_SAYS(refusal<InvalidInput>("\nOpen CASCADE Topology V4 (c)\n"), "binary BREP");
}

TEST(Refusal, BrepCutAnywhere) {
  const std::string whole = test::brep_text(test::filleted_box());
  for (std::size_t percent = 1; percent < 100; percent += 7) {
    const std::string cut = whole.substr(0, 60 + (whole.size() - 80) * percent / 100);
    EXPECT_SAYS(refusal<InvalidInput>(cut), "cut short");
  }
}

TEST(Refusal, StepCutAnywhere) {
  const std::string whole = test::step_text(test::box(10, 20, 30));
  for (std::size_t percent = 1; percent < 100; percent += 7) {
    EXPECT_SAYS(refusal<InvalidInput>(whole.substr(0, 20 + (whole.size() - 40) * percent / 100)),
                "cut short");
  }
}

TEST(Refusal, StepWithBrokenSyntaxOrNothingInIt) {
  RunControl control;
  EXPECT_THROW(BrepModel::from_text("ISO-10303-21;\nthis is no header END-ISO-10303-21;", control), Error);
  EXPECT_THROW(
      BrepModel::from_text("ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n", control),
      Error);
}

TEST(Refusal, StepWithScope) {
  const std::string text = "ISO-10303-21;\nDATA;\n#1=&SCOPE\nENDSCOPE X();\nENDSEC;\nEND-ISO-10303-21;\n";
  EXPECT_SAYS(refusal<InvalidInput>(text), "SCOPE");
}

TEST(Refusal, StepWithAReferenceToNothing) {
  std::string text = test::step_text(test::box(10, 20, 30));
  const std::size_t line = text.find("LINE('',#");
  ASSERT_NE(line, std::string::npos);
  text.insert(line + 9, "99999");
  const std::string message = refusal<InvalidInput>(text);
  EXPECT_SAYS(message, "damaged at #");
}

TEST(Refusal, NoSolid) {
  const std::string shell = test::brep_text(shell_of(test::box(1, 2, 3), 0));
  EXPECT_SAYS(refusal<GeometryError>(shell), "no solid, only 1 shell with 6 faces");
  const TopoDS_Shape face = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Shape();
  EXPECT_SAYS(refusal<GeometryError>(test::brep_text(face)), "no solid");
}

TEST(Refusal, OpenShellNamesAnEdgeAndItsFace) {
  const TopoDS_Solid open = solid_of(shell_of(test::box(1, 2, 3), 1));
  const std::string message = refusal<GeometryError>(test::brep_text(open));
  EXPECT_SAYS(message, "open");
  EXPECT_SAYS(message, "Edge");
  EXPECT_SAYS(message, "bounds only Face");
}

TEST(Refusal, FacesThatAreNotSewnNameEachOther) {
  // The same box twice: the lid of the one has edges of its own.
  const TopoDS_Shell most = shell_of(test::box(1, 2, 3), 1);
  TopoDS_Shape lid;
  for (TopExp_Explorer it(test::box(1, 2, 3), TopAbs_FACE); it.More(); it.Next()) lid = it.Current();
  TopoDS_Shell shell = most;
  BRep_Builder().Add(shell, lid);
  const std::string message = refusal<GeometryError>(test::brep_text(solid_of(shell)));
  EXPECT_SAYS(message, "is not closed against Face");
  EXPECT_SAYS(message, "runs beside it, at most 0 mm off");
  EXPECT_SAYS(message, "sew");
}

TEST(Refusal, FaceThatOccursTwice) {
  TopoDS_Shell shell = shell_of(test::box(1, 2, 3), 0);
  const TopoDS_Face first = TopoDS::Face(TopExp_Explorer(shell, TopAbs_FACE).Current());
  TopoDS_Face twin = TopoDS::Face(first.EmptyCopied());
  const BRep_Builder builder;
  for (TopoDS_Iterator it(first); it.More(); it.Next()) builder.Add(twin, it.Value());
  builder.Add(shell, twin);
  const std::string message = refusal<GeometryError>(test::brep_text(solid_of(shell)));
  EXPECT_SAYS(message, "more than two");
  EXPECT_SAYS(message, "Face7");
}

TEST(Refusal, InfiniteFace) {
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, BRepBuilderAPI_MakeFace(gp_Pln()).Face());
  EXPECT_SAYS(refusal<GeometryError>(test::brep_text(solid_of(shell))), "finite box first");
}

TEST(Refusal, ZeroVolume) {
  // A sheet with a front and a back.
  const TopoDS_Face front = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 1, 0, 1).Face();
  TopoDS_Face back = TopoDS::Face(front.EmptyCopied());
  const BRep_Builder builder;
  for (TopoDS_Iterator it(front); it.More(); it.Next()) builder.Add(back, it.Value());
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, front);
  builder.Add(shell, back.Reversed());
  EXPECT_SAYS(refusal<GeometryError>(test::brep_text(solid_of(shell))), "Solid1 has no volume");
}

TEST(Refusal, HalfSpace) {
  const TopoDS_Face plane = BRepBuilderAPI_MakeFace(gp_Pln(), -1, 1, -1, 1).Face();
  const TopoDS_Shape half = BRepPrimAPI_MakeHalfSpace(plane, gp_Pnt(0, 0, 5)).Solid();
  RunControl control;
  EXPECT_THROW(BrepModel::from_text(test::brep_text(half), control), GeometryError);
}

TEST(Refusal, Cancelled) {
  RunControl control;
  control.cancel();
  EXPECT_THROW(BrepModel::from_text(test::brep_text(test::box(1, 2, 3)), control), Cancelled);
}

TEST(Acceptance, SolidInsideOutIsTurned) {
  const TopoDS_Shape inverted = solid_of(TopoDS::Shell(shell_of(test::box(1, 2, 3), 0).Reversed()));
  const auto [model, boundary] = test::sampled(inverted);
  EXPECT_NEAR(model.volume(), 6.0, 1e-9);
  ASSERT_EQ(model.notes().size(), 1u);
  EXPECT_SAYS(model.notes()[0], "Solid1 was inside out");
  EXPECT_TRUE(model.contains({0.5, 1.0, 1.5}));
  EXPECT_FALSE(model.contains({5.0, 1.0, 1.5}));
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    const auto& [a, b, c] = boundary.triangles[i];
    const Vec3 normal =
        (boundary.points[b] - boundary.points[a]).cross(boundary.points[c] - boundary.points[a]);
    const Vec3 from_centre = boundary.points[a] - Vec3(0.5, 1.0, 1.5);
    EXPECT_GT(normal.dot(from_centre), 0.0);
    EXPECT_GT(model.project_to_face(boundary.triangle_face[i], boundary.points[a]).normal.dot(from_centre),
              0.0);
  }
}

TEST(Acceptance, StepLengthsBecomeMillimetres) {
  RunControl control;
  std::string text = test::step_text(test::box(10, 20, 30));
  EXPECT_NEAR(BrepModel::from_text(text, control).volume(), 6000.0, 1e-6);
  // The same numbers, said to be metres.
  const std::string milli = "SI_UNIT(.MILLI.,.METRE.)";
  const std::size_t unit = text.find(milli);
  ASSERT_NE(unit, std::string::npos);
  text.replace(unit, milli.size(), "SI_UNIT($,.METRE.)");
  EXPECT_NEAR(BrepModel::from_text(text, control).volume(), 6000.0e9, 1e3);
}

TEST(Acceptance, SeveralStepRootsBecomeOneCompound) {
  RunControl control;
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(50, 0, 0));
  const std::string text =
      test::step_text({test::box(1, 2, 3), test::box(2, 3, 4).Moved(TopLoc_Location(shift))});
  const BrepModel model = BrepModel::from_text(text, control);
  EXPECT_EQ(model.solid_count(), 2);
  EXPECT_NEAR(model.volume(), 6.0 + 24.0, 1e-9);
}

TEST(Acceptance, MirroredAndMovedSolids) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(100, 0, 0), gp_Dir(1, 0, 0)));
  const TopoDS_Shape mirrored = BRepBuilderAPI_Transform(test::filleted_box(), mirror).Shape();
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(5, 6, 7));
  for (const TopoDS_Shape& shape : {mirrored, test::filleted_box().Moved(TopLoc_Location(shift))}) {
    EXPECT_NEAR(test::sampled(shape).second.volume, 24000.0 - (1.0 - M_PI / 4.0) * 500.0, 0.05);
  }
}

}  // namespace
}  // namespace fgmesh
