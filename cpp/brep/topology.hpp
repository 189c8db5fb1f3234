// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <string>
#include <vector>

namespace fgmesh::brep {

/// Which solids a face separates, and how its surface is turned. A face of overlapping solids may bound more:
/// see Topology::require_separation().
struct FaceUse {
  int solid_behind = 0;   ///< SolidN the outward normal points out of; 0: the face bounds no solid
  int solid_before = 0;   ///< SolidN the normal points into; 0: the outside
  bool reversed = false;  ///< the outward normal is opposite to dS/du x dS/dv
};

/// What an edge is to the faces that bound solids.
struct EdgeUse {
  std::vector<int> faces;   ///< FaceN of the bounding faces that meet here, each once, ascending
  int count = 0;            ///< times the edge bounds one of them; a seam counts twice
  bool degenerate = false;  ///< collapsed to a point in space: a pole or an apex
  bool seam = false;        ///< closes one face upon itself
};

/// The numbers FreeCAD gives to the sub-shapes of a shape, and how these touch. Numbers are 1-based and in
/// the order of TopExp::MapShapes over the whole shape. Sub-shapes that bound no solid keep their number but
/// are used by nothing.
class Topology {
 public:
  explicit Topology(const TopoDS_Shape& shape);

  int solid_count() const { return solids_.Extent(); }
  int face_count() const { return faces_.Extent(); }
  int edge_count() const { return edges_.Extent(); }
  int vertex_count() const { return vertices_.Extent(); }

  /// The solid as it stands in the shape, or turned inside out where invert_solid() was called for it.
  TopoDS_Solid solid(int number) const;
  TopoDS_Face face(int number) const;
  TopoDS_Edge edge(int number) const;
  TopoDS_Vertex vertex(int number) const;

  const FaceUse& face_use(int number) const { return face_uses_[number - 1]; }
  const EdgeUse& edge_use(int number) const { return edge_uses_[number - 1]; }

  int face_number(const TopoDS_Shape& face) const { return faces_.FindIndex(face); }
  int edge_number(const TopoDS_Shape& edge) const { return edges_.FindIndex(edge); }
  int vertex_number(const TopoDS_Shape& vertex) const { return vertices_.FindIndex(vertex); }

  TopoDS_Compound compound_of_solids() const;

  /// Corrects a solid whose faces all point inwards; numbers stay.
  void invert_solid(int number);

  /// Throws GeometryError where a face does not separate one solid from the outside or from one other solid
  /// on its other side.
  void require_separation() const;

  /// "Face12", "Edge3", "Vertex1", "Solid2"; shells and wires are named by their first face or edge.
  std::string name(const TopoDS_Shape& sub_shape) const;

 private:
  void find_face_uses();
  void find_edge_uses();

  TopTools_IndexedMapOfShape solids_, faces_, edges_, vertices_;
  std::vector<bool> inverted_;
  std::vector<FaceUse> face_uses_;
  std::vector<EdgeUse> edge_uses_;
};

}  // namespace fgmesh::brep
