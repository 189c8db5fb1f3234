// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/smoothness.hpp"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "brep/occt.hpp"

namespace fgmesh::brep {
namespace {

// Radians; imported faces that are meant to join smoothly differ by up to a degree or two.
constexpr double smooth_angle = 0.05;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Not normalised; zero at singular points.
Vec3 surface_normal(const Geom_Surface& surface, const gp_Pnt2d& uv) {
  gp_Pnt position;
  gp_Vec du, dv;
  surface.D1(uv.X(), uv.Y(), position, du, dv);
  return to_vec3(du.Crossed(dv));
}

/// The two parameter curves of a seam: one for each orientation of the edge in the face.
bool is_smooth_seam(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  double first = 0.0, last = 0.0;
  const auto side = [&](TopAbs_Orientation orientation) {
    return BRep_Tool::CurveOnSurface(TopoDS::Edge(edge.Oriented(orientation)), face, first, last);
  };
  const Handle(Geom2d_Curve) left = side(TopAbs_FORWARD), right = side(TopAbs_REVERSED);
  if (left.IsNull() || right.IsNull()) return true;
  constexpr int probes = 9;
  for (int i = 1; i <= probes; ++i) {
    const double t = first + (last - first) * i / (probes + 1);
    if (!normals_agree(*BRep_Tool::Surface(face), left->Value(t), right->Value(t))) return false;
  }
  return true;
}

}  // namespace

bool normals_agree(const Geom_Surface& surface, const gp_Pnt2d& a, const gp_Pnt2d& b) {
  return angle_between(surface_normal(surface, a), surface_normal(surface, b)) <= smooth_angle;
}

bool tangents_agree(const Geom_Curve& curve, double first, double last) {
  gp_Pnt position;
  gp_Vec start, end;
  curve.D1(first, position, start);
  curve.D1(last, position, end);
  return start.Magnitude() > 0.0 && end.Magnitude() > 0.0 && start.Angle(end) <= smooth_angle;
}

bool is_crease(const Topology& topology, int edge) {
  const EdgeUse& use = topology.edge_use(edge);
  if (use.count == 0 || use.degenerate) return false;
  return !use.seam || !is_smooth_seam(topology.edge(edge), topology.face(use.faces.front()));
}

}  // namespace fgmesh::brep
