// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/invalid_parts.hpp"

#include <BRepCheck_Analyzer.hxx>
#include <BRepCheck_ListOfStatus.hxx>
#include <BRepCheck_Result.hxx>
#include <TopExp.hxx>
#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace fgmesh::brep {
namespace {

const char* in_words(BRepCheck_Status status) {
  switch (status) {
    case BRepCheck_InvalidPointOnCurve:
    case BRepCheck_InvalidPointOnCurveOnSurface:
    case BRepCheck_InvalidPointOnSurface:
      return "lies farther from its edge or face than its tolerance allows";
    case BRepCheck_No3DCurve:
    case BRepCheck_Multiple3DCurve:
    case BRepCheck_Invalid3DCurve:
      return "has no proper curve in space";
    case BRepCheck_NoCurveOnSurface:
    case BRepCheck_InvalidCurveOnSurface:
    case BRepCheck_InvalidCurveOnClosedSurface:
      return "does not lie on a face that it bounds";
    case BRepCheck_InvalidSameRangeFlag:
    case BRepCheck_InvalidSameParameterFlag:
      return "runs differently in space and on its faces";
    case BRepCheck_InvalidDegeneratedFlag:
      return "is marked as collapsed to a point but is not, or the reverse";
    case BRepCheck_FreeEdge:
    case BRepCheck_InvalidMultiConnexity:
      return "bounds one face only, or more than two";
    case BRepCheck_InvalidRange:
      return "has an empty range of parameters";
    case BRepCheck_EmptyWire:
    case BRepCheck_EmptyShell:
      return "is empty";
    case BRepCheck_RedundantEdge:
    case BRepCheck_RedundantWire:
    case BRepCheck_RedundantFace:
      return "occurs twice";
    case BRepCheck_SelfIntersectingWire:
      return "has a boundary that crosses itself";
    case BRepCheck_NoSurface:
      return "has no surface";
    case BRepCheck_IntersectingWires:
      return "has boundaries that cross each other";
    case BRepCheck_InvalidWire:
    case BRepCheck_InvalidImbricationOfWires:
      return "has a hole that is not inside its outer boundary";
    case BRepCheck_InvalidImbricationOfShells:
    case BRepCheck_EnclosedRegion:
      return "has shells that do not nest";
    case BRepCheck_NotClosed:
      return "is not closed";
    case BRepCheck_NotConnected:
      return "falls into unconnected pieces";
    case BRepCheck_UnorientableShape:
    case BRepCheck_BadOrientation:
    case BRepCheck_BadOrientationOfSubshape:
      return "is turned against its neighbours";
    case BRepCheck_SubshapeNotInShape:
      return "refers to a part that is not in the shape";
    case BRepCheck_InvalidPolygonOnTriangulation:
      return "carries a wrong triangulation";
    case BRepCheck_InvalidToleranceValue:
      return "has an impossible tolerance";
    default:
      return "cannot be checked";
  }
}

void note_faults(const BRepCheck_ListOfStatus& statuses, const std::string& name,
                 std::vector<std::string>& faults) {
  for (const BRepCheck_Status status : statuses) {
    if (status == BRepCheck_NoError) continue;
    const std::string fault = name + " " + in_words(status);
    if (std::find(faults.begin(), faults.end(), fault) == faults.end()) faults.push_back(fault);
  }
}

bool has_nesting_fault(BRepCheck_Status status) {
  return status == BRepCheck_SubshapeNotInShape || status == BRepCheck_InvalidImbricationOfShells ||
         status == BRepCheck_EnclosedRegion;
}

/// " (of Face1, Face2)": the faces that an edge bounds.
std::string faces_at(const TopoDS_Shape& edge, const Topology& topology) {
  const int number = topology.edge_number(edge);
  std::string names;
  if (number > 0)
    for (const int face : topology.edge_use(number).faces)
      names += (names.empty() ? " (of Face" : ", Face") + std::to_string(face);
  return names.empty() ? names : names + ")";
}

/// Whether more than two faces of a shell meet at one of its edges.
bool is_crowded(const TopoDS_Shape& edge, const Topology& topology) {
  const int number = topology.edge_number(edge);
  return number > 0 && topology.edge_use(number).faces.size() > 2;
}

/// What BRepCheck says of the shells of a solid with cavities, it says with the words for other things.
std::string cavities_of(const TopoDS_Shape& solid, const Topology& topology) {
  TopTools_IndexedMapOfShape shells;
  TopExp::MapShapes(solid, TopAbs_SHELL, shells);
  std::string names;
  for (int i = 1; i <= shells.Extent(); ++i) names += (i == 1 ? "" : ", ") + topology.name(shells(i));
  return names;
}

/// The faults of one sub-shape: by itself, and as part of each face or solid that holds it.
void collect_faults(const BRepCheck_Analyzer& analyzer, const TopoDS_Shape& sub_shape,
                    const Topology& topology, std::vector<std::string>& faults) {
  const Handle(BRepCheck_Result)& result = analyzer.Result(sub_shape);
  if (result.IsNull()) return;
  std::string name = topology.name(sub_shape);
  if (sub_shape.ShapeType() == TopAbs_SOLID) {
    const bool nested = std::none_of(result->Status().begin(), result->Status().end(), has_nesting_fault);
    if (!nested) {
      faults.push_back(
          name + " has a cavity that is not inside its outer shell, or two that are not apart (" +
          cavities_of(sub_shape, topology) + "); cut the cavity out with Part -> Boolean -> Cut");
      return;
    }
  }
  if (sub_shape.ShapeType() == TopAbs_EDGE) name += faces_at(sub_shape, topology);
  note_faults(result->Status(), name, faults);
  for (result->InitContextIterator(); result->MoreShapeInContext(); result->NextShapeInContext()) {
    const bool is_wire_of_face =
        sub_shape.ShapeType() == TopAbs_WIRE && result->ContextualShape().ShapeType() == TopAbs_FACE;
    note_faults(result->StatusOnShape(), is_wire_of_face ? topology.name(result->ContextualShape()) : name,
                faults);
  }
}

}  // namespace

std::vector<std::string> faults_of(const TopoDS_Shape& shape, const Topology& topology) {
  std::vector<std::string> faults;
  const BRepCheck_Analyzer analyzer(shape);
  if (analyzer.IsValid()) return faults;
  for (const auto type : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_WIRE, TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID}) {
    TopTools_IndexedMapOfShape sub_shapes;
    TopExp::MapShapes(shape, type, sub_shapes);
    for (int i = 1; i <= sub_shapes.Extent(); ++i) collect_faults(analyzer, sub_shapes(i), topology, faults);
  }
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent() && topology.solid_count() == 1; ++i)
    if (is_crowded(edges(i), topology))
      faults.insert(faults.begin(), topology.name(edges(i)) + faces_at(edges(i), topology) +
                                        " joins more than two faces; remove the needless one");
  if (faults.empty()) faults.push_back(topology.name(shape) + " is not valid");
  return faults;
}

void require_valid(const TopoDS_Shape& solid, const Topology& topology) {
  const std::vector<std::string> faults = faults_of(solid, topology);
  if (faults.empty()) return;
  std::string message = faults.front();
  constexpr std::size_t most_named = 3;
  for (std::size_t i = 1; i < std::min(most_named, faults.size()); ++i) message += "; " + faults[i];
  if (faults.size() > most_named) message += "; and " + std::to_string(faults.size() - most_named) + " more";
  throw GeometryError(message +
                      ". Part -> Check geometry shows the places; Part -> Refine shape, or exporting "
                      "the part again with a finer tolerance, may help");
}

}  // namespace fgmesh::brep
