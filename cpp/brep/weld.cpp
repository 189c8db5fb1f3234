// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/weld.hpp"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

#include "brep/occt.hpp"
#include "brep/smoothness.hpp"

namespace fgmesh::brep {
namespace {

/// A misfit between triangulations; never leaves this file.
struct Misfit {
  std::string fault;
};

/// A piece of a face's border, the face on its left.
struct BorderSide {
  std::array<int, 2> nodes{};   ///< of the face's triangulation, from 0
  std::array<int, 2> points{};  ///< common to all faces that meet here
};

class Welder {
 public:
  Welder(const CheckedShape& shape, const TriangulatedCopy& triangulated)
      : topology_(shape.topology),
        triangulated_(triangulated),
        vertex_points_(topology_.vertex_count(), -1),
        edge_points_(topology_.edge_count()),
        longest_bridged_(1e-5 * shape.bounds.diagonal()) {
    sampling_.faces.resize(topology_.face_count());
    sampling_.edge_parameters.resize(topology_.edge_count());
    boundary().bounds = shape.bounds;
    boundary().volume = shape.volume();
    boundary().solid_count = topology_.solid_count();
    boundary().face_count = topology_.face_count();
  }

  Sampling run() {
    for (int face = 1; face <= topology_.face_count(); ++face) {
      if (topology_.face_use(face).solid_behind != 0) add_face(face);
    }
    for (int edge = 1; edge <= topology_.edge_count(); ++edge) {
      if (is_crease(topology_, edge)) add_curve(edge);
    }
    add_corners();
    return std::move(sampling_);
  }

 private:
  SampledBoundary& boundary() { return sampling_.boundary; }

  int add_point(const gp_Pnt& position) {
    boundary().points.push_back(to_vec3(position));
    return static_cast<int>(boundary().points.size()) - 1;
  }

  int vertex_point(const TopoDS_Vertex& vertex) {
    int& point = vertex_points_[topology_.vertex_number(vertex) - 1];
    if (point < 0) point = add_point(BRep_Tool::Pnt(vertex));
    return point;
  }

  /// The common points of an edge, made from its first polygon: exactly on its curve, not on one of its
  /// faces.
  const std::vector<int>& edge_points(int number, const Poly_PolygonOnTriangulation& polygon) {
    std::vector<int>& points = edge_points_[number - 1];
    if (!points.empty()) return points;
    TopoDS_Vertex first, last;
    TopExp::Vertices(topology_.edge(number), first, last);
    const int count = polygon.NbNodes();
    if (topology_.edge_use(number).degenerate) {
      points.assign(count, vertex_point(first));
      return points;
    }
    double low = 0.0, high = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(topology_.edge(number), low, high);
    for (int i = 1; i <= count; ++i) {
      const double t = std::clamp(polygon.Parameter(i), low, high);
      sampling_.edge_parameters[number - 1].push_back(t);
      const bool is_end = i == 1 || i == count;
      points.push_back(is_end ? vertex_point(i == 1 ? first : last) : add_point(curve->Value(t)));
    }
    return points;
  }

  void add_border(const TopoDS_Edge& edge, const TopoDS_Face& face,
                  const Poly_PolygonOnTriangulation& polygon, const Poly_Triangulation& triangulation,
                  std::vector<BorderSegment>& border) const {
    const EdgeUse& use = topology_.edge_use(topology_.edge_number(edge));
    double low = 0.0, high = 0.0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, low, high);
    for (int i = 1; i < polygon.NbNodes(); ++i) {
      const gp_Pnt2d start = triangulation.UVNode(polygon.Node(i));
      const gp_Pnt2d end = triangulation.UVNode(polygon.Node(i + 1));
      BorderSegment segment{{start.X(), start.Y()},
                            {end.X(), end.Y()},
                            {},
                            !use.seam && !use.degenerate,
                            curve,
                            {polygon.Parameter(i), polygon.Parameter(i + 1)}};
      if (!curve.IsNull()) {
        const gp_Pnt2d middle = curve->Value(0.5 * (polygon.Parameter(i) + polygon.Parameter(i + 1)));
        segment.bulge = {std::abs(middle.X() - 0.5 * (start.X() + end.X())),
                         std::abs(middle.Y() - 0.5 * (start.Y() + end.Y()))};
      }
      border.push_back(segment);
    }
  }

  void weld_edges(int number, const Handle(Poly_Triangulation) & triangulation,
                  const TopLoc_Location& location, std::vector<int>& common, std::vector<BorderSide>& sides) {
    const std::string name = "Face" + std::to_string(number);
    const TopoDS_Face face = topology_.face(number);
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      const bool bounds = edge.Orientation() == TopAbs_FORWARD || edge.Orientation() == TopAbs_REVERSED;
      if (!bounds) continue;
      const int edge_number = topology_.edge_number(edge);
      const Handle(Poly_PolygonOnTriangulation) polygon =
          BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(triangulated_(edge)), triangulation, location);
      if (polygon.IsNull() || !polygon->HasParameters()) {
        throw Misfit{name + " cannot be triangulated along Edge" + std::to_string(edge_number)};
      }
      const std::vector<int>& points = edge_points(edge_number, *polygon);
      if (static_cast<int>(points.size()) != polygon->NbNodes() &&
          !topology_.edge_use(edge_number).degenerate) {
        throw Misfit{name + " is sampled otherwise than its neighbour along Edge" +
                     std::to_string(edge_number)};
      }
      const bool backward =
          (edge.Orientation() == TopAbs_REVERSED) != (face.Orientation() == TopAbs_REVERSED);
      const auto wanted = [&](int i) { return points[std::min<std::size_t>(i, points.size()) - 1]; };
      for (int i = 1; i <= polygon->NbNodes(); ++i) {
        int& point = common[polygon->Node(i) - 1];
        if (point < 0) point = wanted(i);
        if ((boundary().points[point] - boundary().points[wanted(i)]).norm() > longest_bridged_) {
          throw Misfit{name + " is too narrow beside Edge" + std::to_string(edge_number)};
        }
        if (i == 1) continue;
        const int from = backward ? i : i - 1, to = backward ? i - 1 : i;
        sides.push_back({{polygon->Node(from) - 1, polygon->Node(to) - 1}, {wanted(from), wanted(to)}});
      }
      add_border(edge, face, *polygon, *triangulation, sampling_.faces[number - 1].border);
    }
  }

  void add_face(int number) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangulation =
        BRep_Tool::Triangulation(TopoDS::Face(triangulated_(topology_.face(number))), location);
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0 || !triangulation->HasUVNodes()) {
      throw Misfit{"Face" + std::to_string(number) + " cannot be triangulated"};
    }
    std::vector<int> common(triangulation->NbNodes(), -1);
    std::vector<BorderSide> sides;
    weld_edges(number, triangulation, location, common, sides);

    FaceSamples& samples = sampling_.faces[number - 1];
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(topology_.face(number));
    for (int i = 1; i <= triangulation->NbNodes(); ++i) {
      int& point = common[i - 1];
      const gp_Pnt2d uv = triangulation->UVNode(i);
      if (point < 0) point = add_point(surface->Value(uv.X(), uv.Y()));
      samples.points.push_back(boundary().points[point]);
      samples.uv.push_back({uv.X(), uv.Y()});
    }
    add_triangles(number, *triangulation, common);
    add_slivers(number, sides, common);
  }

  void add_triangles(int number, const Poly_Triangulation& triangulation, const std::vector<int>& common) {
    for (int i = 1; i <= triangulation.NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      triangulation.Triangle(i).Get(a, b, c);
      std::array<int, 3> triangle{common[a - 1], common[b - 1], common[c - 1]};
      const bool collapsed =
          triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
      if (collapsed) continue;
      sampling_.faces[number - 1].triangles.push_back({a - 1, b - 1, c - 1});
      add_triangle(number, triangle);
    }
  }

  /// `triangle` as the surface looks, not the solid.
  void add_triangle(int number, std::array<int, 3> triangle) {
    const FaceUse& use = topology_.face_use(number);
    if (use.reversed) std::swap(triangle[1], triangle[2]);
    boundary().triangles.push_back(triangle);
    boundary().triangle_face.push_back(number);
    boundary().triangle_solids.push_back({use.solid_behind, use.solid_before});
  }

  /// Where points of the border are so near to each other that BRepMesh made one node of them, the triangles
  /// have one of the points; those added here lie between them and the border with all of its points.
  void add_slivers(int number, const std::vector<BorderSide>& sides, const std::vector<int>& common) {
    const auto add = [&](int a, int b, int c) {
      if (a != b && b != c && c != a) add_triangle(number, {a, b, c});
    };
    for (const BorderSide& side : sides) {
      const int from = common[side.nodes[0]], to = common[side.nodes[1]];
      add(from, side.points[0], side.points[1]);
      add(from, side.points[1], to);
    }
  }

  void add_curve(int number) {
    boundary().curves.push_back({number, edge_points_[number - 1], sampling_.edge_parameters[number - 1],
                                 topology_.edge_use(number).faces});
  }

  void add_corners() {
    for (int vertex = 1; vertex <= topology_.vertex_count(); ++vertex) {
      const int point = vertex_points_[vertex - 1];
      if (point >= 0) boundary().corners.push_back({vertex, point});
    }
  }

  const Topology& topology_;
  const TriangulatedCopy& triangulated_;
  std::vector<int> vertex_points_;
  std::vector<std::vector<int>> edge_points_;
  double longest_bridged_;  // mm: points that are farther from each other never become one
  Sampling sampling_;
};

}  // namespace

std::optional<Sampling> weld(const CheckedShape& shape, const TriangulatedCopy& triangulated,
                             std::string& fault) {
  try {
    return Welder(shape, triangulated).run();
  } catch (const Misfit& misfit) {
    fault = misfit.fault;
    return std::nullopt;
  }
}

}  // namespace fgmesh::brep
