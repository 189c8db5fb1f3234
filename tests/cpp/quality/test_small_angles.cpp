// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "quality/mesh_statistics.hpp"
#include "quality/small_angles.hpp"

namespace fgmesh {
namespace {

/// Face1 is the plane z = 0, Face2 the plane z = 0.2; no edges. The normal of Face1 points out of the wall,
/// or into it, where a solid with a lower number is below.
class Wall final : public BoundaryGeometry {
 public:
  explicit Wall(double first_normal) : first_normal_(first_normal) {}
  SurfacePoint project_to_face(int face, const Vec3& p, const double*) const override {
    SurfacePoint found;
    found.position = {p.x(), p.y(), face == 1 ? 0.0 : 0.2};
    found.normal = {0, 0, face == 1 ? first_normal_ : 1.0};
    return found;
  }
  CurvePoint project_to_edge(int, const Vec3&, const double*) const override { return {}; }
  Vec3 vertex_position(int) const override { return Vec3::Zero(); }
  bool contains(const Vec3&, int, bool) const override { return true; }

 private:
  double first_normal_;
};

/// A tetrahedron from one side of the wall to the other.
TetMesh across(double reach) {
  TetMesh mesh;
  mesh.points = {{0, 0, 0}, {reach, 0, 0}, {0, reach, 0}, {reach / 4, reach / 4, 0.2}};
  mesh.carriers = {{2, 1}, {2, 1}, {2, 1}, {2, 2}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.tet_solids = {1};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  mesh.triangle_faces = {1, 2};
  return mesh;
}

struct Told {
  SmallAngles angles;
  std::vector<std::string> messages;
};

Told told(const TetMesh& mesh, double min_size, double first_normal = -1.0) {
  const std::vector<double> smallest = smallest_dihedrals(mesh);
  const auto name = [](const Carrier& part) { return "part " + std::to_string(part.number); };
  SmallAngles angles = find_small_angles(mesh, smallest, Wall(first_normal), min_size, name);
  return {angles, describe(angles, mesh, smallest)};
}

const std::vector<std::int32_t> kNone, kFirst = {0};

TEST(SmallAngles, AreForcedWhereTheWallIsThinnerThanTheSmallestSize) {
  const Told found = told(across(20.0), 0.21);
  EXPECT_EQ(found.angles.forced, kFirst);
  EXPECT_EQ(found.angles.unforced, kNone);
  ASSERT_EQ(found.messages.size(), 1u);
  EXPECT_NE(found.messages[0].find("the shape forces: walls are thinner than MinSize, 0.21 mm"),
            std::string::npos)
      << found.messages[0];
}

TEST(SmallAngles, AreForcedInAThinLayerOnAnotherSolid) {
  TetMesh mesh = across(20.0);
  mesh.points.push_back({5, 5, -10});
  mesh.carriers.push_back({3, 1});
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  mesh.tet_solids = {2, 1};
  EXPECT_EQ(told(mesh, 0.21, 1.0).angles.forced, kFirst);
  EXPECT_EQ(told(mesh, 0.19, 1.0).angles.forced, kNone);
}

TEST(SmallAngles, AreNotForcedWhereElementsMayBeAsSmallAsTheWall) {
  const Told found = told(across(20.0), 0.19);
  EXPECT_EQ(found.angles.forced, kNone);
  EXPECT_EQ(found.angles.unforced, kFirst);
  ASSERT_EQ(found.messages.size(), 1u);
  EXPECT_NE(found.messages[0].find("1 of 1 tetrahedra"), std::string::npos);
  EXPECT_NE(found.messages[0].find("(6.25, 6.25, 0.05) mm"), std::string::npos) << found.messages[0];
}

TEST(SmallAngles, AreNoneWhereTheTetrahedronIsHighEnough) {
  const Told found = told(across(0.5), 0.21);
  EXPECT_EQ(found.angles.forced, kNone);
  EXPECT_EQ(found.angles.unforced, kNone);
  EXPECT_TRUE(found.messages.empty());
}

}  // namespace
}  // namespace fgmesh
