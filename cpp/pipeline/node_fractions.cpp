// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/node_fractions.hpp"

#include <limits>

namespace fgmesh {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

NodeFractions::NodeFractions(const MeshState& state, const TetMesh& mesh, const std::vector<int>& order)
    : solids_(mesh.tet_solids.begin(), mesh.tet_solids.end()), values_(state.materials().count()) {
  for (int solid : solids_) materials_.push_back(state.materials().of_solid(solid));
  for (std::vector<double>& values : values_) values.assign(order.size(), kUnknown);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vertex& vertex = state.vertices[order[i]];
    first_material_.push_back(vertex.material);
    values_[vertex.material][i] = vertex.value;
    for (const MaterialValue& other : vertex.others) values_[other.material][i] = other.value;
  }
}

void NodeFractions::add_middle_nodes(const MeshState& state, const SecondOrderMesh& mesh,
                                     RunControl& control) {
  for (std::vector<double>& values : values_) values.resize(mesh.points.size(), kUnknown);
  std::vector<int> lowest(mesh.points.size(), std::numeric_limits<int>::max());
  first_material_.resize(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    control.check();
    std::vector<double>& values = values_[materials_[t]];
    for (int k = 0; k < 6; ++k) {
      const std::int32_t node = mesh.tets[t][4 + k];
      if (solids_[t] < lowest[node]) {
        lowest[node] = solids_[t];
        first_material_[node] = materials_[t];
      }
      if (!std::isnan(values[node])) continue;
      MaterialValue found;
      found.material = materials_[t];
      const Carrier carrier =
          mesh.carriers[node].dimension == 3 ? Carrier{3, solids_[t]} : mesh.carriers[node];
      const auto& [i, j] = kMiddleEdges[k];
      // Between chord and true boundary, outside the solid, f may be undefined.
      values[node] = state.evaluate(mesh.points[node], carrier, found)
                         ? found.value
                         : 0.5 * (values[mesh.tets[t][i]] + values[mesh.tets[t][j]]);
    }
  }
}

std::vector<double> NodeFractions::at_points() const {
  std::vector<double> result;
  result.reserve(first_material_.size());
  for (std::size_t i = 0; i < first_material_.size(); ++i) result.push_back(values_[first_material_[i]][i]);
  return result;
}

}  // namespace fgmesh
