// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include "brep_shapes.hpp"

namespace fgmesh {
namespace {

class Numbering : public testing::TestWithParam<bool> {
 protected:
  TopoDS_Shape shape() const { return GetParam() ? test::two_joined_boxes() : test::filleted_box(); }
};

TEST_P(Numbering, CountsAreThoseOfTheShape) {
  const BrepModel model = test::read(shape());
  TopTools_IndexedMapOfShape solids, faces, edges, vertices;
  TopExp::MapShapes(shape(), TopAbs_SOLID, solids);
  TopExp::MapShapes(shape(), TopAbs_FACE, faces);
  TopExp::MapShapes(shape(), TopAbs_EDGE, edges);
  TopExp::MapShapes(shape(), TopAbs_VERTEX, vertices);
  EXPECT_EQ(model.solid_count(), solids.Extent());
  EXPECT_EQ(model.face_count(), faces.Extent());
  EXPECT_EQ(model.edge_count(), edges.Extent());
  EXPECT_EQ(model.vertex_count(), vertices.Extent());
}

TEST_P(Numbering, VerticesKeepTheirPlaces) {
  const BrepModel model = test::read(shape());
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape(), TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i) {
    const gp_Pnt expected = BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)));
    EXPECT_LT((model.vertex_position(i) - Vec3(expected.X(), expected.Y(), expected.Z())).norm(), 1e-9);
  }
}

TEST_P(Numbering, TrianglesLieOnTheFaceOfTheirNumber) {
  const TopoDS_Shape original = shape();
  const SampledBoundary boundary = test::sampled(original).second;
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(original, TopAbs_FACE, faces);
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    for (const int point : boundary.triangles[i]) {
      const Vec3& p = boundary.points[point];
      const BRepClass_FaceClassifier place(TopoDS::Face(faces(boundary.triangle_face[i])),
                                           gp_Pnt(p.x(), p.y(), p.z()), 1e-6);
      ASSERT_NE(place.State(), TopAbs_OUT);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Numbering, testing::Bool());

}  // namespace
}  // namespace fgmesh
