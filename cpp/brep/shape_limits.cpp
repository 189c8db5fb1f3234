// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_limits.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "brep/occt.hpp"

namespace fgmesh::brep {
namespace {

/// How far an edge runs off one of its faces, at most, mm; 0 where OpenCASCADE has no curve on it.
double distance_from_face(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double low = 0.0, high = 0.0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, low, high);
  const Handle(Geom2d_Curve) on_face = BRep_Tool::CurveOnSurface(edge, face, low, high);
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
  if (curve.IsNull() || on_face.IsNull() || surface.IsNull()) return 0.0;
  constexpr int count = 16;
  double largest = 0.0;
  for (int i = 0; i <= count; ++i) {
    const double t = low + (high - low) * i / count;
    const gp_Pnt2d uv = on_face->Value(t);
    largest = std::max(largest, curve->Value(t).Distance(surface->Value(uv.X(), uv.Y())));
  }
  return largest;
}

[[noreturn]] void refuse_gap(const std::string& one, const std::string& other, double gap) {
  std::ostringstream text;
  text << one << " lies " << gap << " mm off " << other
       << ", which its tolerance hides; rebuild the faces there, or export the part again with a finer "
          "tolerance";
  throw GeometryError(text.str());
}

void require_vertices_on(const TopoDS_Edge& edge, const std::string& name, const Topology& topology,
                         double allowed) {
  const BRepAdaptor_Curve curve(edge);
  for (const TopoDS_Vertex& vertex : {TopExp::FirstVertex(edge), TopExp::LastVertex(edge)}) {
    if (vertex.IsNull()) continue;
    const double gap = BRep_Tool::Pnt(vertex).Distance(curve.Value(BRep_Tool::Parameter(vertex, edge)));
    if (gap > allowed) refuse_gap(topology.name(vertex), "the end of " + name, gap);
  }
}

}  // namespace

void require_finite(const Topology& topology) {
  for (int number = 1; number <= topology.vertex_count(); ++number) {
    const Vec3 position = to_vec3(BRep_Tool::Pnt(topology.vertex(number)));
    const std::string name = "Vertex" + std::to_string(number);
    if (!position.allFinite())
      throw GeometryError(name + " has a coordinate that is no number; export the part again");
    if (Precision::IsInfinite(position.cwiseAbs().maxCoeff()))
      throw GeometryError(name + " lies at infinity; cut the solid with a finite box first");
  }
}

void require_size(const Box& bounds) {
  constexpr double samples = 2000.0;  // of the finest distance from the surface, along the diagonal
  const double least = Precision::Confusion();
  std::ostringstream text;
  const double reach = bounds.low.cwiseAbs().cwiseMax(bounds.high.cwiseAbs()).maxCoeff();
  if (bounds.diagonal() < samples * least) {
    text << "the part is only " << bounds.diagonal() << " mm large, and OpenCASCADE takes points nearer than "
         << least << " mm for one: scale Solid1 up (Draft -> Scale), and the mesh down";
  } else if (reach * std::numeric_limits<double>::epsilon() > least) {
    text << "the part reaches to " << reach
         << " mm from the origin, where numbers are rounded by more than the " << least
         << " mm that OpenCASCADE tells points apart by: move Solid1 to the origin, or scale it down (Draft "
            "-> "
            "Scale) and the mesh up";
  } else {
    return;
  }
  throw GeometryError(text.str());
}

void require_thickness(int solid, double volume, double area, double diagonal) {
  constexpr double thinnest = 1e-4;
  const double thickness = 2.0 * volume / area;
  if (thickness >= thinnest * diagonal) return;
  std::ostringstream text;
  text << "the walls of Solid" << solid << " are " << thickness << " mm thick on average, less than "
       << thinnest << " of the part's " << diagonal
       << " mm: no tetrahedra of good shape fit in there; thicken it, cut out a smaller part, or take shell "
          "elements";
  throw GeometryError(text.str());
}

void require_small_gaps(const Topology& topology, double diagonal) {
  const double allowed = 1e-3 * diagonal;
  for (int number = 1; number <= topology.edge_count(); ++number) {
    const EdgeUse& use = topology.edge_use(number);
    if (use.count == 0 || use.degenerate) continue;
    const TopoDS_Edge edge = topology.edge(number);
    const std::string name = "Edge" + std::to_string(number);
    require_vertices_on(edge, name, topology, allowed);
    if (BRep_Tool::Tolerance(edge) <= allowed) continue;
    for (const int face : use.faces) {
      const double gap = distance_from_face(edge, topology.face(face));
      if (gap > allowed) refuse_gap(name, "Face" + std::to_string(face), gap);
    }
  }
}

std::string largest_gap(const Topology& topology, double diagonal) {
  double largest = 1e-6 * diagonal;
  std::ostringstream text;
  for (int number = 1; number <= topology.edge_count(); ++number) {
    const EdgeUse& use = topology.edge_use(number);
    if (use.count == 0 || use.degenerate) continue;
    for (const int face : use.faces) {
      const double gap = distance_from_face(topology.edge(number), topology.face(face));
      if (gap <= largest) continue;
      largest = gap;
      text.str({});
      text << "Edge" << number << " runs up to " << gap << " mm beside Face" << face;
    }
  }
  return text.str();
}

}  // namespace fgmesh::brep
