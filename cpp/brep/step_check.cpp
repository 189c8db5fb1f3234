// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/step_check.hpp"

#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_HGraph.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepShape_BrepWithVoids.hxx>
#include <StepShape_ClosedShell.hxx>
#include <StepShape_FacetedBrepAndBrepWithVoids.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <StepShape_OrientedClosedShell.hxx>
#include <StepShape_ShapeRepresentation.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <cstring>

#include "core/error.hpp"

namespace fgmesh::brep {
namespace {

std::string label(const Interface_InterfaceModel& model, const Handle(Standard_Transient) & entity) {
  return model.StringLabel(entity)->ToCString();
}

/// Whether the shape, where a part of it lies or how large it is depends on entities of this type.
bool shapes_depend_on(const std::string& type) {
  const auto begins = [&](const char* prefix) { return type.rfind(prefix, 0) == 0; };
  const auto has = [&](const char* word) { return type.find(word) != std::string::npos; };
  if (begins("StepGeom_") || begins("StepShape_")) return true;
  if (begins("StepRepr_")) return has("Transformation") || has("MappedItem") || has("RepresentationMap");
  return begins("StepBasic_") && (has("Unit") || has("DimensionalExponents"));
}

/// Whether a fault is in an attribute that no geometry is made from: names, and what merely describes a
/// spline.
bool is_descriptive(const Interface_Check& check, int fault) {
  if (std::strstr(check.CFail(fault, Standard_False), "not a quoted String")) return true;
  const char* message = check.CFail(fault);
  constexpr const char* attributes[] = {"(knot_spec)", "(curve_form)", "(surface_form)", "(self_intersect)"};
  return std::any_of(std::begin(attributes), std::end(attributes),
                     [&](const char* attribute) { return std::strstr(message, attribute) != nullptr; });
}

int count_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape parts;
  TopExp::MapShapes(shape, type, parts);
  return parts.Extent();
}

struct Declared {
  int shells = 0, faces = 0;

  void add(const Handle(StepShape_ConnectedFaceSet) & shell) {
    ++shells;
    if (!shell.IsNull()) faces += shell->NbCfsFaces();
  }
};

template <class Brep>
void add_voids(const Handle(Standard_Transient) & entity, Declared& declared) {
  const Handle(Brep) brep = Handle(Brep)::DownCast(entity);
  if (brep.IsNull()) return;
  for (int i = 1; i <= brep->NbVoids(); ++i) {
    ++declared.shells;
    const Handle(StepShape_OrientedClosedShell) hollow = brep->VoidsValue(i);
    if (hollow.IsNull() || hollow->ClosedShellElement().IsNull()) continue;
    declared.faces += hollow->ClosedShellElement()->NbCfsFaces();
  }
}

/// The shells and faces that a solid's entity lists; one shell of no faces where it is no boundary.
Declared declared_by(const Handle(Standard_Transient) & entity) {
  Declared declared;
  const Handle(StepShape_ManifoldSolidBrep) brep = Handle(StepShape_ManifoldSolidBrep)::DownCast(entity);
  brep.IsNull() ? declared.add({}) : declared.add(brep->Outer());
  add_voids<StepShape_BrepWithVoids>(entity, declared);
  add_voids<StepShape_FacetedBrepAndBrepWithVoids>(entity, declared);
  return declared;
}

/// Whether an entity stands in a representation of a shape. Others are operands, or only have a colour.
bool is_represented(const Interface_Graph& graph, const Handle(Standard_Transient) & entity) {
  Interface_EntityIterator users = graph.Sharings(entity);
  for (users.Start(); users.More(); users.Next())
    if (users.Value()->IsKind(STANDARD_TYPE(StepShape_ShapeRepresentation))) return true;
  return false;
}

[[noreturn]] void refuse_lost(const std::string& name, const std::string& what) {
  throw GeometryError("the STEP file describes a solid at " + name + " of which " + what +
                      "; repair it where it was made, or export it again as exact solids in AP214 or AP242");
}

}  // namespace

std::vector<std::string> harmless_faults(const STEPControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  Interface_CheckIterator faults = reader.WS()->ModelCheckList();
  int harmless = 0;
  std::string first;
  for (faults.Start(); faults.More(); faults.Next()) {
    const int number = faults.Number();
    const Handle(Interface_Check) check = faults.Value();
    if (!check->HasFailed() || number < 1) continue;
    const Handle(Standard_Transient) entity = model->Value(number);
    const bool matters = shapes_depend_on(entity->DynamicType()->Name()) || model->IsUnknownEntity(number);
    for (int fault = 1; fault <= check->NbFails(); ++fault) {
      const std::string told = label(*model, entity) + " (" + check->CFail(fault) + ")";
      if (matters && !is_descriptive(*check, fault))
        throw InvalidInput("the STEP file is damaged at " + told + "; export it again");
      if (harmless++ == 0) first = told;
    }
  }
  if (harmless == 0) return {};
  return {"the STEP file breaks rules of the format in " + std::to_string(harmless) +
          (harmless == 1 ? " place, " : " places, the first ") + first +
          "; the shape does not depend on that, and all its solids were read"};
}

std::vector<std::string> require_all_solids(const STEPControl_Reader& reader) {
  const Handle(Interface_InterfaceModel) model = reader.Model();
  const Handle(Transfer_TransientProcess) process = reader.WS()->TransferReader()->TransientProcess();
  reader.WS()->ComputeGraph();
  const Interface_Graph& graph = reader.WS()->HGraph()->Graph();
  std::vector<std::string> notes;
  for (int number = 1; number <= model->NbEntities(); ++number) {
    const Handle(Standard_Transient) entity = model->Value(number);
    if (!entity->IsKind(STANDARD_TYPE(StepShape_SolidModel))) continue;
    const std::string name = label(*model, entity);
    const TopoDS_Shape made = TransferBRep::ShapeResult(process, entity);
    if (made.IsNull()) {
      if (is_represented(graph, entity)) refuse_lost(name, "OpenCASCADE makes no shape");
      continue;
    }
    const Declared declared = declared_by(entity);
    if (count_of(made, TopAbs_SHELL) < declared.shells)
      refuse_lost(name, "a shell was lost, a cavity perhaps");
    const int faces = count_of(made, TopAbs_FACE);
    if (faces < declared.faces)
      notes.push_back("of the " + std::to_string(declared.faces) + " faces of the solid at " + name +
                      " in the STEP file " + std::to_string(faces) +
                      " were read; they close without the rest");
  }
  return notes;
}

}  // namespace fgmesh::brep
