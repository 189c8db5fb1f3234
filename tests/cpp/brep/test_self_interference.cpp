// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <set>

#include "brep/self_interference.hpp"
#include "core/error.hpp"

namespace fgmesh::brep {
namespace {

Topology two_boxes(double x) {
  TopoDS_Compound both;
  const BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 10)).Solid());
  builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt(x, 5, 5), gp_Pnt(x + 10, 15, 15)).Solid());
  return Topology(both);
}

TEST(SelfInterference, NamesTheFacesOfTwoBoxesThatCross) {
  // Three sides of the one meet three of the other around the common corner, each but the parallel one.
  const Topology boxes = two_boxes(5.0);
  RunControl control;
  int faces = 0;
  std::set<std::array<int, 2>> pairs;
  for (const auto& [first, second] : self_interferences(boxes, control)) {
    if (first.dimension != 2 || second.dimension != 2) continue;
    ++faces;
    pairs.insert({first.number, second.number});
    EXPECT_LE(first.number, 6);
    EXPECT_GT(second.number, 6);
  }
  EXPECT_EQ(faces, 6);
  EXPECT_EQ(pairs.size(), 6u);
}

TEST(SelfInterference, FindsNothingBetweenBoxesThatAreApart) {
  const Topology boxes = two_boxes(11.0);
  RunControl control;
  EXPECT_TRUE(self_interferences(boxes, control).empty());
}

TEST(SelfInterference, EndsWhereItIsAskedTo) {
  const Topology boxes = two_boxes(5.0);
  RunControl control;
  control.cancel();
  EXPECT_THROW(self_interferences(boxes, control), Cancelled);
}

}  // namespace
}  // namespace fgmesh::brep
