// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopoDS.hxx>
#include <map>
#include <vector>

#include "brep_shapes.hpp"

// Valid shapes that are sampled only with care: edges almost as short as the least length that OpenCASCADE
// knows.
namespace fgmesh {
namespace {

/// Of `boundary`, whose triangles meet in pairs; fails where they do not.
double closed_volume(const SampledBoundary& boundary) {
  std::map<std::pair<int, int>, int> sides;
  double volume = 0.0;
  for (const auto& [a, b, c] : boundary.triangles) {
    ++sides[{a, b}];
    ++sides[{b, c}];
    ++sides[{c, a}];
    volume += boundary.points[a].dot(boundary.points[b].cross(boundary.points[c])) / 6.0;
  }
  for (const auto& [side, count] : sides) {
    const auto other = sides.find({side.second, side.first});
    EXPECT_TRUE(other != sides.end() && other->second == count) << side.first << ", " << side.second;
  }
  return volume;
}

TopoDS_Face profile(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

class TinyEdge : public testing::TestWithParam<double> {};

TEST_P(TinyEdge, OfAPrismIsSampled) {
  const double length = GetParam();
  const TopoDS_Face base =
      profile({{0, 0, 0}, {60, 0, 0}, {60, 40, 0}, {30, 40, 0}, {30 - length, 40, 0}, {0, 30, 0}});
  const auto [model, boundary] = test::sampled(BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 20)).Shape());
  EXPECT_NEAR(closed_volume(boundary), 45000.0, 1e-2);
  EXPECT_EQ(boundary.corners.size(), 12u);
  EXPECT_EQ(boundary.curves.size(), 18u);
}

TEST_P(TinyEdge, NextToAnotherIsSampled) {
  const double l = GetParam();
  const TopoDS_Face base = profile({{0, 0, 0},
                                    {60, 0, 0},
                                    {60, 40 - l, 0},
                                    {60 - 0.6 * l, 40 + 0.2 * l, 0},
                                    {60 - 1.8 * l, 40 + l, 0},
                                    {0, 40, 0}});
  const auto [model, boundary] = test::sampled(BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, 20)).Shape());
  EXPECT_NEAR(closed_volume(boundary), 48000.0, 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Sloppy, TinyEdge, testing::Values(1.5e-7, 3e-7, 1e-6, 1e-5));

}  // namespace
}  // namespace fgmesh
