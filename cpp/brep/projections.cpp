// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/projections.hpp"

namespace fgmesh::brep {

Projections::Projections(const Topology& topology, const Sampling& sampling, RunControl& control) {
  edges.resize(topology.edge_count());
  faces.resize(topology.face_count());
  for (int edge = 1; edge <= topology.edge_count(); ++edge) {
    const std::vector<double>& parameters = sampling.edge_parameters[edge - 1];
    if (!parameters.empty()) edges[edge - 1].emplace(topology.edge(edge), parameters);
  }
  for (int face = 1; face <= topology.face_count(); ++face) {
    control.check();
    const FaceSamples& samples = sampling.faces[face - 1];
    if (!samples.points.empty()) faces[face - 1].emplace(topology, face, samples, edges);
  }
}

}  // namespace fgmesh::brep
