// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_check.hpp"

#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_VinertGK.hxx>
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "brep/fragments.hpp"
#include "brep/invalid_parts.hpp"
#include "brep/occt.hpp"
#include "brep/open_shells.hpp"
#include "brep/shape_healing.hpp"
#include "brep/shape_limits.hpp"
#include "brep/told_as_separated.hpp"

namespace fgmesh::brep {
namespace {

std::string counted(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void require_geometry(const Topology& topology) {
  for (int face = 1; face <= topology.face_count(); ++face) {
    TopLoc_Location location;
    if (topology.face_use(face).solid_behind == 0) continue;
    if (BRep_Tool::Surface(topology.face(face), location).IsNull()) {
      throw GeometryError("Face" + std::to_string(face) +
                          " has no surface, only triangles perhaps; convert the mesh into a solid first");
    }
  }
}

/// Some exporters leave out the curve in space of an edge that lies on two surfaces.
void build_missing_curves(const Topology& topology, std::vector<std::string>& notes) {
  for (int number = 1; number <= topology.edge_count(); ++number) {
    const EdgeUse& use = topology.edge_use(number);
    if (use.count == 0 || use.degenerate) continue;
    double first = 0.0, last = 0.0;
    if (!BRep_Tool::Curve(topology.edge(number), first, last).IsNull()) continue;
    const std::string name = "Edge" + std::to_string(number);
    if (!BRepLib::BuildCurve3d(topology.edge(number))) {
      throw GeometryError(name + " has no curve in space and none can be built; rebuild its faces");
    }
    notes.push_back(name + " had no curve in space; it was built from its faces");
  }
}

Box bounds_of(const Topology& topology) {
  Bnd_Box box;
  for (int number = 1; number <= topology.solid_count(); ++number) {
    BRepBndLib::AddOptimal(topology.solid(number), box, Standard_False, Standard_False);
  }
  if (box.IsVoid()) throw GeometryError("the solid has no extent; rebuild it");
  if (box.IsOpen()) throw GeometryError("the solid reaches to infinity; cut it with a finite box first");
  Box bounds{to_vec3(box.CornerMin()), to_vec3(box.CornerMax())};
  if (!bounds.low.allFinite() || !bounds.high.allFinite() ||
      Precision::IsInfinite(bounds.high.cwiseAbs().cwiseMax(bounds.low.cwiseAbs()).maxCoeff())) {
    throw GeometryError("the solid reaches to infinity; cut it with a finite box first");
  }
  return bounds;
}

/// Volume of a solid; one whose faces all point inwards is turned.
double volume_of(int number, double diagonal, Topology& topology, std::vector<std::string>& notes) {
  const std::string name = "Solid" + std::to_string(number);
  GProp_GProps boundary;
  BRepGProp::SurfaceProperties(topology.solid(number), boundary);
  const double volume = enclosed_volume(topology.solid(number));
  const double area = std::abs(boundary.Mass());
  // Volume over area is the order of the mean wall thickness: none, where rounding alone makes more.
  constexpr double thinnest_wall = 1e-9;
  if (!std::isfinite(volume) || std::abs(volume) <= thinnest_wall * area * diagonal) {
    require_valid(topology.solid(number), topology);  // which may know the cause
    throw GeometryError(name + " has no volume (its faces lie upon each other or are turned); rebuild it");
  }
  if (volume < 0.0) {
    topology.invert_solid(number);
    notes.push_back(name + " was inside out; its faces were turned");
  }
  require_thickness(number, std::abs(volume), area, diagonal);
  return std::abs(volume);
}

void note_unused_faces(const Topology& topology, std::vector<std::string>& notes) {
  int unused = 0;
  for (int face = 1; face <= topology.face_count(); ++face)
    unused += topology.face_use(face).solid_behind == 0;
  if (unused > 0) notes.push_back(counted(unused, "face") + " of the shape bound no solid and are left out");
}

double largest_tolerance(const Topology& topology) {
  double tolerance = 0.0;
  for (int number = 1; number <= topology.edge_count(); ++number) {
    if (topology.edge_use(number).count == 0) continue;
    const TopoDS_Edge edge = topology.edge(number);
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(edge));
    for (TopExp_Explorer it(edge, TopAbs_VERTEX); it.More(); it.Next()) {
      tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Vertex(it.Current())));
    }
  }
  return tolerance;
}

/// What must be so for anything to be measured, or healed.
CheckedShape begin_check(const TopoDS_Shape& shape) {
  CheckedShape checked{Topology(shape), {}, {}, 0.0, {}, {}};
  const Topology& topology = checked.topology;
  require_solid(shape, topology);
  require_finite(topology);
  require_geometry(topology);
  build_missing_curves(topology, checked.notes);
  require_closed(topology);
  checked.bounds = bounds_of(topology);
  require_size(checked.bounds);
  return checked;
}

void finish_check(CheckedShape& checked, RunControl& control) {
  Topology& topology = checked.topology;
  const double diagonal = checked.bounds.diagonal();
  for (int number = 1; number <= topology.solid_count(); ++number) {
    checked.volumes.push_back(volume_of(number, diagonal, topology, checked.notes));
    control.check();
  }
  for (int number = 1; number <= topology.solid_count(); ++number) {
    require_valid(topology.solid(number), topology);
    control.check();
  }
  require_small_gaps(topology, diagonal);
  note_unused_faces(topology, checked.notes);
  checked.tolerance = largest_tolerance(topology);
}

/// The shape healed and checked; nothing where that does not help.
std::optional<CheckedShape> check_healed(const TopoDS_Shape& shape, RunControl& control) {
  try {
    return guarded("healing the shape", [&]() -> std::optional<CheckedShape> {
      std::optional<HealedShape> healed = heal(shape, control);
      if (!healed) return std::nullopt;
      CheckedShape checked = begin_check(healed->shape);
      checked.notes.insert(checked.notes.begin(), healed->notes.begin(), healed->notes.end());
      finish_check(checked, control);
      return checked;
    });
  } catch (const GeometryError&) {
    return std::nullopt;
  }
}

}  // namespace

double CheckedShape::volume() const { return std::accumulate(volumes.begin(), volumes.end(), 0.0); }

double enclosed_volume(const TopoDS_Shape& solid) {
  // Gauss-Kronrod: the plain call is wrong by 1 % on long B-spline faces, the adaptive Gauss one by 20 % on a
  // closed profile extruded (OCCT 7.6).
  constexpr double relative_error = 1e-4;
  // Sums cones from a point to each face. BRepGProp takes the origin of the shape's placement, and goes on
  // for a minute where a face lies in a plane through it, whose share is rounding alone: no face of a design
  // aims at this point.
  Bnd_Box box;
  BRepBndLib::Add(solid, box, Standard_False);
  const Vec3 low = to_vec3(box.CornerMin()), high = to_vec3(box.CornerMax());
  const Vec3 apex = 0.5 * (low + high) + (high - low).norm() * Vec3(0.0137, -0.0071, 0.0113);
  BRepGProp_Face surface;
  BRepGProp_VinertGK cone;
  cone.SetLocation(gp_Pnt(apex.x(), apex.y(), apex.z()));
  double volume = 0.0;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face& face = TopoDS::Face(it.Current());
    if (face.Orientation() != TopAbs_FORWARD && face.Orientation() != TopAbs_REVERSED) continue;
    surface.Load(face);
    BRepGProp_Domain edges(face);
    cone.Perform(surface, edges, relative_error);
    volume += cone.Mass();
  }
  return volume;
}

CheckedShape check_solids(const TopoDS_Shape& shape, RunControl& control) {
  return guarded("checking the shape", [&] {
    CheckedShape checked = begin_check(shape);
    control.check();
    try {
      finish_check(checked, control);
    } catch (const GeometryError&) {
      std::optional<CheckedShape> healed = check_healed(shape, control);
      if (!healed) throw;  // what is wrong with the shape as it came
      return std::move(*healed);
    }
    return checked;
  });
}

CheckedShape check_shape(const TopoDS_Shape& shape, RunControl& control) {
  CheckedShape checked = check_solids(shape, control);
  std::optional<Fragments> fragments =
      guarded("separating the solids", [&] { return fragment(checked.topology, checked.volumes, control); });
  if (fragments) {
    std::vector<std::string> notes = std::move(checked.notes);
    checked = told_as_separated(true, [&] { return check_solids(fragments->shape, control); });
    checked.origins = std::move(fragments->origins);
    checked.notes = std::move(notes);
    checked.notes.insert(checked.notes.end(), fragments->notes.begin(), fragments->notes.end());
  }
  checked.topology.require_separation();
  return checked;
}

}  // namespace fgmesh::brep
