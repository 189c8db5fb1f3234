// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shown_surface.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "brep/occt.hpp"
#include "brep/shape_reader.hpp"

namespace fgmesh {
namespace brep {
namespace {

constexpr double fine_angle = 0.1;  // where a face has no triangles yet
constexpr int edge_samples = 32;    // of each smooth piece of an edge
constexpr int most_pieces = 16;
constexpr int face_samples = 20000;  // of all faces together
constexpr int fewest_steps = 4, most_steps = 64;

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, kind, found);
  return found;
}

void triangulate(const TopoDS_Shape& shape, double deflection, double angle, RunControl& control) {
  IMeshTools_Parameters parameters;
  parameters.Deflection = std::max(deflection, Precision::Confusion());
  parameters.Angle = angle;
  Handle(StopIndicator) indicator = new StopIndicator(control);
  BRepMesh_IncrementalMesh(shape, parameters, indicator->Start());
  control.check();
}

bool lacks_triangles(const TopTools_IndexedMapOfShape& faces) {
  TopLoc_Location place;
  for (int i = 1; i <= faces.Extent(); ++i) {
    if (BRep_Tool::Triangulation(TopoDS::Face(faces(i)), place).IsNull()) return true;
  }
  return false;
}

FaceTriangles triangles_of(const TopoDS_Face& face, int solid) {
  FaceTriangles found;
  found.solid = solid;
  TopLoc_Location place;
  const Handle(Poly_Triangulation) triangulation = BRep_Tool::Triangulation(face, place);
  if (triangulation.IsNull()) return found;
  const gp_Trsf moved = place.Transformation();
  const bool is_turned = (face.Orientation() == TopAbs_REVERSED) != moved.IsNegative();
  for (int i = 1; i <= triangulation->NbNodes(); ++i) {
    found.points.push_back(to_vec3(triangulation->Node(i).Transformed(moved)));
  }
  for (int i = 1; i <= triangulation->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangulation->Triangle(i).Get(a, b, c);
    if (is_turned) std::swap(b, c);
    found.triangles.push_back({a - 1, b - 1, c - 1});
  }
  return found;
}

void add_edge_points(const TopoDS_Edge& edge, std::vector<Vec3>& points) {
  if (BRep_Tool::Degenerated(edge)) return;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), last = curve.LastParameter();
  if (curve.GetType() == GeomAbs_Line || Precision::IsInfinite(first) || Precision::IsInfinite(last)) return;
  const int count = edge_samples * std::clamp(curve.NbIntervals(GeomAbs_C1), 1, most_pieces);
  for (int i = 0; i <= count; ++i) points.push_back(to_vec3(curve.Value(first + (last - first) * i / count)));
}

bool has_straight_lines(const TopoDS_Face& face) {
  const GeomAbs_SurfaceType kind = BRepAdaptor_Surface(face, Standard_False).GetType();
  return kind == GeomAbs_Plane || kind == GeomAbs_Cylinder || kind == GeomAbs_Cone ||
         kind == GeomAbs_SurfaceOfExtrusion;
}

/// On a grid of `steps` by `steps` in (u, v).
void add_face_points(const TopoDS_Face& face, int steps, std::vector<Vec3>& points) {
  double u_low = 0.0, u_high = 0.0, v_low = 0.0, v_high = 0.0;
  BRepTools::UVBounds(face, u_low, u_high, v_low, v_high);
  for (const double bound : {u_low, u_high, v_low, v_high}) {
    if (Precision::IsInfinite(bound)) return;
  }
  const BRepAdaptor_Surface surface(face, Standard_False);
  const BRepTopAdaptor_FClass2d domain(face, Precision::PConfusion());
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const gp_Pnt2d place(u_low + (u_high - u_low) * i / steps, v_low + (v_high - v_low) * j / steps);
      if (domain.Perform(place) != TopAbs_OUT) points.push_back(to_vec3(surface.Value(place.X(), place.Y())));
    }
  }
}

}  // namespace
}  // namespace brep

std::vector<FaceTriangles> shown_triangles(const std::string& shape, double deflection, double angle,
                                           RunControl& control) {
  using namespace brep;
  const TopoDS_Shape read = read_shape(shape, control).shape;
  control.begin_stage("triangulating");
  return guarded("triangulating the shape", [&] {
    BRepTools::Clean(read);
    triangulate(read, deflection, angle, control);
    std::vector<FaceTriangles> found;
    const TopTools_IndexedMapOfShape solids = parts_of(read, TopAbs_SOLID);
    for (int solid = 1; solid <= solids.Extent(); ++solid) {
      const TopTools_IndexedMapOfShape faces = parts_of(solids(solid), TopAbs_FACE);
      if (lacks_triangles(faces)) triangulate(solids(solid), deflection, fine_angle, control);
      for (int i = 1; i <= faces.Extent(); ++i) {
        found.push_back(triangles_of(TopoDS::Face(faces(i)), solid - 1));
      }
    }
    return found;
  });
}

std::vector<Vec3> reach_points(const std::string& shape, RunControl& control) {
  using namespace brep;
  const TopoDS_Shape read = read_shape(shape, control).shape;
  return guarded("measuring the shape", [&] {
    std::vector<Vec3> points;
    const TopTools_IndexedMapOfShape vertices = parts_of(read, TopAbs_VERTEX);
    for (int i = 1; i <= vertices.Extent(); ++i)
      points.push_back(to_vec3(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)))));
    const TopTools_IndexedMapOfShape edges = parts_of(read, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) add_edge_points(TopoDS::Edge(edges(i)), points);
    const TopTools_IndexedMapOfShape faces = parts_of(read, TopAbs_FACE);
    std::vector<TopoDS_Face> rounded;
    for (int i = 1; i <= faces.Extent(); ++i) {
      if (!has_straight_lines(TopoDS::Face(faces(i)))) rounded.push_back(TopoDS::Face(faces(i)));
    }
    const double share =
        std::sqrt(static_cast<double>(face_samples) / std::max<std::size_t>(rounded.size(), 1));
    const int steps = std::clamp(static_cast<int>(share), fewest_steps, most_steps);
    for (const TopoDS_Face& face : rounded) {
      control.check();
      add_face_points(face, steps, points);
    }
    return points;
  });
}

}  // namespace fgmesh
