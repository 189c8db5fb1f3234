// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/node_fractions.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace fgmesh {
namespace {

Composition mean(const Composition& a, const Composition& b) {
  Composition result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = 0.5 * (a[i] + b[i]);
  return result;
}

}  // namespace

NodeFractions::NodeFractions(const MeshState& state, const TetMesh& mesh, const std::vector<int>& order)
    : solids_(mesh.tet_solids.begin(), mesh.tet_solids.end()), values_(state.materials().count()) {
  for (int solid : solids_) materials_.push_back(state.materials().of_solid(solid));
  for (int m = 0; m < state.materials().count(); ++m) {
    columns_ = std::max(columns_, state.materials().field(m).constituents());
    values_[m].resize(order.size());
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vertex& vertex = state.vertices[order[i]];
    first_material_.push_back(vertex.own.material);
    values_[vertex.own.material][i] = vertex.own.composition;
    for (const MaterialValue& other : vertex.others) values_[other.material][i] = other.composition;
  }
}

void NodeFractions::add_middle_nodes(const MeshState& state, const SecondOrderMesh& mesh,
                                     RunControl& control) {
  for (std::vector<Composition>& values : values_) values.resize(mesh.points.size());
  std::vector<int> lowest(mesh.points.size(), std::numeric_limits<int>::max());
  first_material_.resize(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    control.check();
    std::vector<Composition>& values = values_[materials_[t]];
    for (int k = 0; k < 6; ++k) {
      const std::int32_t node = mesh.tets[t][4 + k];
      if (solids_[t] < lowest[node]) {
        lowest[node] = solids_[t];
        first_material_[node] = materials_[t];
      }
      if (!values[node].empty()) continue;
      MaterialValue found;
      found.material = materials_[t];
      const Carrier carrier =
          mesh.carriers[node].dimension == 3 ? Carrier{3, solids_[t]} : mesh.carriers[node];
      const auto& [i, j] = kMiddleEdges[k];
      // Between chord and true boundary, outside the solid, a formula may be undefined.
      values[node] = state.evaluate(mesh.points[node], carrier, found)
                         ? found.composition
                         : mean(values[mesh.tets[t][i]], values[mesh.tets[t][j]]);
    }
  }
}

std::vector<double> NodeFractions::at_points() const {
  std::vector<double> result;
  result.reserve(first_material_.size() * columns_);
  for (std::size_t i = 0; i < first_material_.size(); ++i)
    put_row(first_material_[i], static_cast<std::int32_t>(i), result);
  return result;
}

std::vector<double> NodeFractions::variations(const std::vector<std::array<std::int32_t, 4>>& tets) const {
  std::vector<double> result;
  result.reserve(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto& [a, b, c, d] = tets[t];
    const int material = materials_[t];
    result.push_back(
        composition_variation(at(material, a), at(material, b), at(material, c), at(material, d)));
  }
  return result;
}

void NodeFractions::put_row(int material, std::int32_t node, std::vector<double>& rows) const {
  const Composition& fractions = at(material, node);
  rows.insert(rows.end(), fractions.begin(), fractions.end());
  // Fractions that sum up to more than one by rounding leave no remainder.
  rows.push_back(std::max(0.0, 1.0 - std::accumulate(fractions.begin(), fractions.end(), 0.0)));
  rows.insert(rows.end(), columns_ - fractions.size() - 1, 0.0);
}

}  // namespace fgmesh
