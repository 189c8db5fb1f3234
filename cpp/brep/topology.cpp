// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/topology.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "core/error.hpp"

namespace fgmesh::brep {
namespace {

bool bounds_matter(const TopoDS_Shape& sub_shape) {
  return sub_shape.Orientation() == TopAbs_FORWARD || sub_shape.Orientation() == TopAbs_REVERSED;
}

[[noreturn]] void refuse_face(int face, const std::string& what) {
  throw GeometryError("Face" + std::to_string(face) + " " + what +
                      "; Part -> Boolean -> Boolean Fragments, or rebuilding the solid, may help");
}

}  // namespace

TopoDS_Compound Topology::compound_of_solids() const {
  TopoDS_Compound solids;
  const BRep_Builder builder;
  builder.MakeCompound(solids);
  for (int number = 1; number <= solid_count(); ++number) builder.Add(solids, solid(number));
  return solids;
}

Topology::Topology(const TopoDS_Shape& shape) {
  TopExp::MapShapes(shape, TopAbs_SOLID, solids_);
  TopExp::MapShapes(shape, TopAbs_FACE, faces_);
  TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
  inverted_.assign(solids_.Extent(), false);
  find_face_uses();
  find_edge_uses();
}

TopoDS_Solid Topology::solid(int number) const {
  const TopoDS_Shape& solid = solids_(number);
  return TopoDS::Solid(inverted_[number - 1] ? solid.Reversed() : solid);
}

TopoDS_Face Topology::face(int number) const { return TopoDS::Face(faces_(number)); }
TopoDS_Edge Topology::edge(int number) const { return TopoDS::Edge(edges_(number)); }
TopoDS_Vertex Topology::vertex(int number) const { return TopoDS::Vertex(vertices_(number)); }

void Topology::invert_solid(int number) {
  inverted_[number - 1] = !inverted_[number - 1];
  find_face_uses();
}

void Topology::find_face_uses() {
  face_uses_.assign(faces_.Extent(), FaceUse{});
  for (int number = 1; number <= solid_count(); ++number) {
    for (TopExp_Explorer it(solid(number), TopAbs_FACE); it.More(); it.Next()) {
      const int face = faces_.FindIndex(it.Current());
      if (!bounds_matter(it.Current())) {
        refuse_face(face, "lies inside Solid" + std::to_string(number) + " without bounding it");
      }
      FaceUse& use = face_uses_[face - 1];
      const bool reversed = it.Current().Orientation() == TopAbs_REVERSED;
      if (use.solid_behind == 0) {
        use = {number, 0, reversed};
      } else if (use.solid_behind == number) {
        refuse_face(face, "bounds Solid" + std::to_string(number) + " twice");
      } else if (use.solid_before == 0) {
        use.solid_before = number;
      }
    }
  }
}

void Topology::require_separation() const {
  for (int number = 1; number <= solid_count(); ++number) {
    for (TopExp_Explorer it(solid(number), TopAbs_FACE); it.More(); it.Next()) {
      const int face = faces_.FindIndex(it.Current());
      const FaceUse& use = face_use(face);
      if (use.solid_behind == number) continue;
      if (use.solid_before != number) refuse_face(face, "bounds more than two solids");
      const bool same_side = (it.Current().Orientation() == TopAbs_REVERSED) == use.reversed;
      if (same_side)
        refuse_face(face, "has Solid" + std::to_string(use.solid_behind) + " and Solid" +
                              std::to_string(number) + " on the same side: they overlap");
    }
  }
}

void Topology::find_edge_uses() {
  edge_uses_.assign(edges_.Extent(), EdgeUse{});
  for (int number = 1; number <= face_count(); ++number) {
    if (face_use(number).solid_behind == 0) continue;
    for (TopExp_Explorer it(faces_(number), TopAbs_EDGE); it.More(); it.Next()) {
      if (!bounds_matter(it.Current())) continue;
      EdgeUse& use = edge_uses_[edges_.FindIndex(it.Current()) - 1];
      ++use.count;
      if (use.faces.empty() || use.faces.back() != number) use.faces.push_back(number);
    }
  }
  for (int number = 1; number <= edge_count(); ++number) {
    EdgeUse& use = edge_uses_[number - 1];
    use.degenerate = BRep_Tool::Degenerated(edge(number));
    use.seam = !use.degenerate && use.faces.size() == 1 && use.count == 2;
  }
}

std::string Topology::name(const TopoDS_Shape& sub_shape) const {
  const auto numbered = [&](const char* kind, const TopTools_IndexedMapOfShape& map) {
    return kind + std::to_string(map.FindIndex(sub_shape));
  };
  switch (sub_shape.ShapeType()) {
    case TopAbs_SOLID:
      return numbered("Solid", solids_);
    case TopAbs_FACE:
      return numbered("Face", faces_);
    case TopAbs_EDGE:
      return numbered("Edge", edges_);
    case TopAbs_VERTEX:
      return numbered("Vertex", vertices_);
    default:
      break;
  }
  const bool is_wire = sub_shape.ShapeType() == TopAbs_WIRE;
  const TopExp_Explorer first(sub_shape, is_wire ? TopAbs_EDGE : TopAbs_FACE);
  if (!first.More()) return is_wire ? "an empty wire" : "an empty shell";
  return (is_wire ? "the wire of " : "the shell of ") + name(first.Current());
}

}  // namespace fgmesh::brep
