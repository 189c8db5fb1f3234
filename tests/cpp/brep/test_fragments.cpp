// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Copy.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <vector>

#include "brep/brep_model.hpp"
#include "brep_shapes.hpp"

namespace fgmesh {
namespace {

TopoDS_Shape cube(double x, double y, double z, double side = 10.0) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), side, side, side).Shape();
}

TopoDS_Shape ball(double radius, double centre) {
  return BRepPrimAPI_MakeSphere(gp_Pnt(centre, centre, centre), radius).Shape();
}

BrepModel read(const std::vector<TopoDS_Shape>& solids) {
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& solid : solids) builder.Add(compound, solid);
  return test::read(compound);
}

/// How many parts come from so many parts of the shape given.
int count_from(const std::vector<std::vector<int>>& origins, std::size_t many) {
  return static_cast<int>(std::count_if(origins.begin(), origins.end(),
                                        [&](const std::vector<int>& from) { return from.size() == many; }));
}

TEST(Fragments, OfSolidsThatAreApartOrShareTheirFacesAreNone) {
  for (const BrepModel& model :
       {read({cube(0, 0, 0), cube(20, 0, 0)}), test::read(test::two_joined_boxes())}) {
    EXPECT_TRUE(model.origins().solids.empty());
    EXPECT_TRUE(model.notes().empty());
    EXPECT_EQ(model.given_solid_count(), 2);
    EXPECT_EQ(model.given_solid(2), 2);
  }
}

TEST(Fragments, OfCubesSideBySideShareAFaceWithBothNames) {
  const BrepModel model = read({cube(0, 0, 0), cube(10, 0, 0)});
  EXPECT_EQ(model.face_count(), 11);
  EXPECT_EQ(model.edge_count(), 20);
  EXPECT_EQ(model.vertex_count(), 12);
  EXPECT_EQ(count_from(model.origins().faces, 2), 1);
  EXPECT_EQ(count_from(model.origins().edges, 2), 4);
  EXPECT_EQ(count_from(model.origins().vertices, 2), 4);
  EXPECT_EQ(count_from(model.origins().faces, 0), 0);
}

TEST(Fragments, OfCubesAsFarApartAsPlacementsLeaveThemShareAFace) {
  for (const double gap : {1e-6, -1e-6}) {
    const BrepModel model = read({cube(0, 0, 0), cube(10 + gap, 0, 0)});
    EXPECT_EQ(model.face_count(), 11);
    EXPECT_EQ(count_from(model.origins().faces, 2), 1);
    EXPECT_NEAR(model.volumes()[0], 1000.0, 1e-3);
    EXPECT_NEAR(model.volumes()[1], 1000.0, 1e-3);
  }
}

TEST(Fragments, OfACornerInCommonBelongToTheFirst) {
  const BrepModel model = read({cube(0, 0, 0), cube(5, 5, 5)});
  EXPECT_EQ(model.origins().solids, (std::vector<int>{1, 2}));
  EXPECT_NEAR(model.volumes()[0], 1000.0, 1e-6);
  EXPECT_NEAR(model.volumes()[1], 875.0, 1e-6);
  // Three faces of the first go on inside the second, and three of the second leave a corner to the first.
  // Six edges are new: both sides of each pair of faces that cut each other.
  EXPECT_EQ(model.face_count(), 15);
  EXPECT_EQ(count_from(model.origins().faces, 1), 15);
  EXPECT_EQ(count_from(model.origins().edges, 0), 6);
}

TEST(Fragments, OfNestedSolidsLeaveEachItsOwn) {
  const auto volume = [](double radius) { return 4.0 / 3.0 * M_PI * std::pow(radius, 3); };
  const TopoDS_Shape room = cube(0, 0, 0, 30.0);
  std::vector<TopoDS_Shape> solids = {room, ball(9.0, 15.0), ball(4.0, 15.0)};
  std::vector<double> volumes = {27000.0 - volume(9.0), volume(9.0) - volume(4.0), volume(4.0)};
  std::vector<int> order = {0, 1, 2};
  do {
    const BrepModel model = read({solids[order[0]], solids[order[1]], solids[order[2]]});
    EXPECT_EQ(model.origins().solids, (std::vector<int>{1, 2, 3}));
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(model.volumes()[i], volumes[order[i]], 1e-3 * volumes[order[i]]);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Fragments, OfWhatStandsThereTwiceBelongToTheFirst) {
  const TopoDS_Shape first = cube(0, 0, 0);
  const BrepModel model = read({first, BRepBuilderAPI_Copy(first).Shape()});
  EXPECT_EQ(model.origins().solids, (std::vector<int>{1}));
  EXPECT_EQ(model.given_solid_count(), 2);
  EXPECT_EQ(count_from(model.origins().faces, 2), 6);
}

TEST(Fragments, OfASolidCutInTwoByAnotherAreBothIts) {
  // The first is a wall across the second.
  const TopoDS_Shape wall = BRepPrimAPI_MakeBox(gp_Pnt(4, -5, -5), 2, 20, 20).Shape();
  const BrepModel model = read({wall, cube(0, 0, 0)});
  EXPECT_EQ(model.origins().solids, (std::vector<int>{1, 2, 2}));
  EXPECT_NEAR(model.volumes()[0], 800.0, 1e-6);
  EXPECT_NEAR(model.volumes()[1] + model.volumes()[2], 800.0, 1e-6);
}

TEST(Fragments, AreOneSolidWhereTheirOwnerIsOne) {
  // The rod pierces the cube, and the cube, the first, has what the rod divides it into.
  const TopoDS_Shape rod = BRepPrimAPI_MakeBox(gp_Pnt(4, 4, -5), 2, 2, 20).Shape();
  const BrepModel model = read({cube(0, 0, 0), rod});
  EXPECT_EQ(model.origins().solids, (std::vector<int>{1, 2, 2}));
  EXPECT_NEAR(model.volumes()[0], 1000.0, 1e-6);
  EXPECT_TRUE(model.contains({5, 5, 5}, 1));
  EXPECT_FALSE(model.contains({5, 5, 5}, 2));
  EXPECT_TRUE(model.contains({5, 5, 14}, 2) || model.contains({5, 5, 14}, 3));
}

}  // namespace
}  // namespace fgmesh
