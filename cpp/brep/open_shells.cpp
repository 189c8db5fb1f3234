// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/open_shells.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "brep/occt.hpp"

namespace fgmesh::brep {
namespace {

/// An edge with one face only, the face, and points along the edge.
struct FreeEdge {
  int edge, face;
  std::vector<Vec3> points;
};

std::vector<Vec3> points_along(const TopoDS_Edge& edge) {
  constexpr int count = 16;
  std::vector<Vec3> points;
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), length = curve.LastParameter() - first;
  for (int i = 0; i <= count; ++i) points.push_back(to_vec3(curve.Value(first + length * i / count)));
  return points;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

/// The largest distance of the points of `a` from the polyline of `b`.
double gap(const FreeEdge& a, const FreeEdge& b) {
  double largest = 0.0;
  for (const Vec3& p : a.points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < b.points.size(); ++i)
      least = std::min(least, distance_to_segment(p, b.points[i - 1], b.points[i]));
    largest = std::max(largest, least);
  }
  return largest;
}

/// Says where the faces of `edges`, which are not empty, are not closed, and what may be done.
std::string describe_opening(const std::vector<FreeEdge>& edges) {
  const FreeEdge* first = &edges.front();
  const FreeEdge* beside = nullptr;
  constexpr double near = 0.01;  // of the length of the edge
  constexpr std::size_t most_compared = 200;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(edges.size(), most_compared); ++i)
    for (std::size_t j = 0; j < std::min(edges.size(), most_compared); ++j) {
      if (i == j || edges[i].points.empty()) continue;
      const double distance = gap(edges[i], edges[j]);
      const double length = (edges[i].points.front() - edges[i].points[edges[i].points.size() / 2]).norm();
      if (distance >= std::min(least, near * length)) continue;
      least = distance;
      first = &edges[i];
      beside = &edges[j];
    }
  std::ostringstream text;
  text << "Edge" << first->edge << " bounds only Face" << first->face;
  if (beside != nullptr) {
    text << ", which is not closed against Face" << beside->face << ": Edge" << beside->edge
         << " runs beside it, at most " << least
         << " mm off, but is not joined with it; sew the faces (Part -> Create shape builder -> Shell from "
            "faces, or ShapeFix)";
  } else {
    text << "; add the missing face, then sew the faces with Part -> Create shape builder";
  }
  return text.str();
}

std::vector<FreeEdge> free_edges_of(const Topology& topology) {
  std::vector<int> count(topology.edge_count(), 0), face_at(topology.edge_count(), 0);
  for (int face = 1; face <= topology.face_count(); ++face)
    for (TopExp_Explorer it(topology.face(face), TopAbs_EDGE); it.More(); it.Next()) {
      const int edge = topology.edge_number(it.Current());
      ++count[edge - 1];
      face_at[edge - 1] = face;
    }
  std::vector<FreeEdge> found;
  for (int edge = 1; edge <= topology.edge_count(); ++edge)
    if (count[edge - 1] == 1 && !BRep_Tool::Degenerated(topology.edge(edge)))
      found.push_back({edge, face_at[edge - 1], points_along(topology.edge(edge))});
  return found;
}

std::string counted(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace

void require_solid(const TopoDS_Shape& shape, const Topology& topology) {
  if (topology.solid_count() > 0) return;
  if (topology.face_count() == 0) {
    throw GeometryError(topology.edge_count() > 0
                            ? "the shape holds no solid and no face, only " +
                                  counted(topology.edge_count(), "edge") +
                                  ", Edge1 the first; choose a solid, or extrude the sketch first"
                            : "the shape is empty: it holds no solid and no face; choose a solid");
  }
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(shape, TopAbs_SHELL, shells);
  const std::string holds = "the shape holds no solid, only " + counted(shells.Extent(), "shell") + " with " +
                            counted(topology.face_count(), "face");
  const std::vector<FreeEdge> free_edges = free_edges_of(topology);
  if (!free_edges.empty()) throw GeometryError(holds + ": " + describe_opening(free_edges));
  throw GeometryError(holds + ", Face1 to Face" + std::to_string(topology.face_count()) +
                      ", closed; make a solid of it with Part -> Create shape builder -> Solid from shell");
}

void require_closed(const Topology& topology) {
  std::vector<FreeEdge> free_edges;
  for (int number = 1; number <= topology.edge_count(); ++number) {
    const EdgeUse& use = topology.edge_use(number);
    if (!use.degenerate && use.count == 1)
      free_edges.push_back({number, use.faces.front(), points_along(topology.edge(number))});
  }
  if (free_edges.empty()) return;
  const int solid = topology.face_use(free_edges.front().face).solid_behind;
  throw GeometryError("the shell of Solid" + std::to_string(solid) +
                      " is open: " + describe_opening(free_edges));
}

}  // namespace fgmesh::brep
