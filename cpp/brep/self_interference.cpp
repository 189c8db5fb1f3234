// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/self_interference.hpp"

#include <BOPAlgo_CheckerSI.hxx>
#include <BOPDS_DS.hxx>
#include <BOPDS_MapOfPair.hxx>
#include <TopTools_ListOfShape.hxx>
#include <algorithm>
#include <tuple>

#include "brep/occt.hpp"

namespace fgmesh::brep {
namespace {

/// Of a face, an edge or a vertex; number 0 for others, and for parts made by the check itself.
Carrier carrier_of(const TopoDS_Shape& part, const Topology& topology) {
  switch (part.ShapeType()) {
    case TopAbs_FACE:
      return {2, topology.face_number(part)};
    case TopAbs_EDGE:
      return {1, topology.edge_number(part)};
    case TopAbs_VERTEX:
      return {0, topology.vertex_number(part)};
    default:
      return {3, 0};
  }
}

std::tuple<int, int> rank(const Carrier& part) { return {-part.dimension, part.number}; }

}  // namespace

std::vector<std::array<Carrier, 2>> self_interferences(const Topology& topology, RunControl& control) {
  TopTools_ListOfShape arguments;
  arguments.Append(topology.compound_of_solids());
  BOPAlgo_CheckerSI checker;
  checker.SetArguments(arguments);
  checker.SetNonDestructive(Standard_True);
  const Handle(StopIndicator) indicator = new StopIndicator(control);
  checker.Perform(indicator->Start());
  control.check();
  std::vector<std::array<Carrier, 2>> found;
  const BOPDS_DS& parts = checker.DS();
  for (BOPDS_MapOfPair::Iterator it(parts.Interferences()); it.More(); it.Next()) {
    int first = 0, second = 0;
    it.Value().Indices(first, second);
    if (parts.IsNewShape(first) || parts.IsNewShape(second)) continue;
    std::array<Carrier, 2> pair{carrier_of(parts.Shape(first), topology),
                                carrier_of(parts.Shape(second), topology)};
    if (pair[0].number == 0 || pair[1].number == 0) continue;
    if (rank(pair[1]) < rank(pair[0])) std::swap(pair[0], pair[1]);
    found.push_back(pair);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::tuple_cat(rank(a[0]), rank(a[1])) < std::tuple_cat(rank(b[0]), rank(b[1]));
  });
  return found;
}

}  // namespace fgmesh::brep
