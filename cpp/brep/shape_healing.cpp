// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/shape_healing.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_ShapeTolerance.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <ShapeFix_ShapeTolerance.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <array>
#include <cmath>
#include <limits>

#include "brep/invalid_parts.hpp"
#include "brep/occt.hpp"
#include "brep/topology.hpp"

namespace fgmesh::brep {
namespace {

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, type, parts);
  return parts;
}

template <class Visit>
void for_each_part(const TopoDS_Shape& shape, TopAbs_ShapeEnum type, const Visit& visit) {
  const TopTools_IndexedMapOfShape parts = parts_of(shape, type);
  for (int i = 1; i <= parts.Extent(); ++i) visit(parts(i));
}

double largest_tolerance(const TopoDS_Shape& shape) {
  return ShapeAnalysis_ShapeTolerance().Tolerance(shape, 1);
}

/// Numbers that change where the geometry of a shape does: of each vertex and edge some points, of each face
/// its area and its centroid.
struct Measures {
  std::vector<gp_Pnt> points;
  std::vector<double> areas, borders;  ///< of each face: mm^2, and the length of its edges, mm
  std::vector<gp_Pnt> centroids;

  explicit Measures(const TopoDS_Shape& shape) {
    for_each_part(shape, TopAbs_VERTEX, [&](const TopoDS_Shape& vertex) {
      points.push_back(BRep_Tool::Pnt(TopoDS::Vertex(vertex)));
    });
    for_each_part(shape, TopAbs_EDGE, [&](const TopoDS_Shape& edge) {
      if (BRep_Tool::Degenerated(TopoDS::Edge(edge))) return;
      const BRepAdaptor_Curve curve(TopoDS::Edge(edge));
      const double first = curve.FirstParameter(), length = curve.LastParameter() - first;
      constexpr int count = 8;
      for (int i = 0; i <= count; ++i) points.push_back(curve.Value(first + length * i / count));
    });
    for_each_part(shape, TopAbs_FACE, [&](const TopoDS_Shape& face) {
      GProp_GProps surface, border;
      BRepGProp::SurfaceProperties(face, surface);
      BRepGProp::LinearProperties(face, border);
      areas.push_back(std::abs(surface.Mass()));
      borders.push_back(border.Mass());
      centroids.push_back(surface.CentreOfMass());
    });
  }

  /// True where nothing lies farther than `tolerance` from where it lies in `other`. The comparisons are
  /// false for what is no number.
  bool agrees(const Measures& other, double tolerance) const {
    if (points.size() != other.points.size() || areas.size() != other.areas.size()) return false;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!(points[i].Distance(other.points[i]) <= tolerance)) return false;
    constexpr double integration_error = 1e-6;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      const double error = tolerance * borders[i] + integration_error * areas[i];
      if (!(std::abs(areas[i] - other.areas[i]) <= error)) return false;
      if (!(areas[i] * centroids[i].Distance(other.centroids[i]) <= error * (borders[i] + tolerance)))
        return false;
    }
    return true;
  }
};

/// `original` with each face as it is in the healed shape, or only turned as it is there. ShapeFix may put
/// the faces of a shell, and the edges of a face, into another order; in here they keep theirs.
TopoDS_Shape rebuilt(const TopoDS_Shape& original, ShapeBuild_ReShape& changes,
                     const TopTools_IndexedMapOfShape& healed_faces, bool only_turned) {
  const BRep_Builder builder;
  const auto filled = [&](auto container) {
    for (TopoDS_Iterator it(original); it.More(); it.Next())
      builder.Add(container, rebuilt(it.Value(), changes, healed_faces, only_turned));
    return container;
  };
  switch (original.ShapeType()) {
    case TopAbs_COMPOUND:
    case TopAbs_COMPSOLID: {
      TopoDS_Compound compound;
      builder.MakeCompound(compound);
      return filled(compound);
    }
    case TopAbs_SOLID: {
      TopoDS_Solid solid;
      builder.MakeSolid(solid);
      return filled(solid);
    }
    case TopAbs_SHELL: {
      TopoDS_Shell shell;
      builder.MakeShell(shell);
      shell.Closed(original.Closed());
      return filled(shell);
    }
    default: {
      const TopoDS_Shape changed = changes.Apply(original);
      const int index = healed_faces.FindIndex(changed);
      if (index == 0) return changed;
      return only_turned ? original.Oriented(healed_faces(index).Orientation()) : healed_faces(index);
    }
  }
}

bool keeps_numbers(const TopoDS_Shape& original, const TopoDS_Shape& healed, ShapeBuild_ReShape& changes) {
  for (const auto type : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX}) {
    const TopTools_IndexedMapOfShape before = parts_of(original, type), after = parts_of(healed, type);
    if (before.Extent() != after.Extent()) return false;
    // Solids are made anew, and stand in the order of their faces.
    for (int i = 1; i <= before.Extent() && type != TopAbs_SOLID; ++i)
      if (!changes.Apply(before(i)).IsSame(after(i))) return false;
  }
  return true;
}

/// Coordinates of a large part, or of one far from the origin, are rounded by more than OpenCASCADE's usual
/// tolerance, which then claims what no number can hold. Returns the least that one can.
double rounding_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  if (box.IsVoid() || box.IsOpen()) return 0.0;
  const Vec3 low = to_vec3(box.CornerMin()), high = to_vec3(box.CornerMax());
  constexpr double operations = 32.0;
  return operations * std::numeric_limits<double>::epsilon() *
         low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
}

/// What is told of the healing: the faces that were turned, else what was wrong before.
std::vector<std::string> notes_of(const TopoDS_Shape& original, const TopoDS_Shape& healed,
                                  const std::vector<std::string>& faults) {
  std::vector<std::string> notes;
  const TopTools_IndexedMapOfShape before = parts_of(original, TopAbs_FACE),
                                   after = parts_of(healed, TopAbs_FACE);
  for (int i = 1; i <= before.Extent(); ++i)
    if (before(i).Orientation() != after(i).Orientation())
      notes.push_back("Face" + std::to_string(i) +
                      " was turned against its neighbours; it was turned back, which changes no point of it");
  for (std::size_t i = 0; i < faults.size() && notes.empty(); ++i)
    notes.push_back(faults[i] + "; that was mended within the tolerance of the shape");
  return notes;
}

}  // namespace

std::optional<HealedShape> heal(const TopoDS_Shape& shape, RunControl& control) {
  const std::vector<std::string> faults = faults_of(shape, Topology(shape));
  if (faults.empty()) return std::nullopt;
  control.check();
  const Measures before(shape);
  const double rounding = rounding_of(shape);
  const double tolerance = std::max({largest_tolerance(shape), Precision::Confusion(), rounding});
  if (rounding > Precision::Confusion()) {
    ShapeFix_ShapeTolerance().LimitTolerance(shape, rounding, 0.0, TopAbs_SHAPE);
    if (faults_of(shape, Topology(shape)).empty()) return HealedShape{shape, notes_of(shape, shape, faults)};
  }

  const Handle(ShapeFix_Shape) fix = new ShapeFix_Shape(shape);
  const Handle(StopIndicator) indicator = new StopIndicator(control);
  fix->Perform(indicator->Start());
  control.check();
  const Handle(ShapeBuild_ReShape) changes = fix->Context();
  const TopTools_IndexedMapOfShape healed_faces = parts_of(fix->Shape(), TopAbs_FACE);
  for (const bool only_turned : {true, false}) {
    const TopoDS_Shape healed = rebuilt(shape, *changes, healed_faces, only_turned);
    if (!faults_of(healed, Topology(healed)).empty()) continue;
    if (!only_turned && !keeps_numbers(shape, healed, *changes)) continue;
    if (largest_tolerance(healed) > tolerance || !Measures(healed).agrees(before, tolerance)) continue;
    return HealedShape{healed, notes_of(shape, healed, faults)};
  }
  return std::nullopt;
}

}  // namespace fgmesh::brep
