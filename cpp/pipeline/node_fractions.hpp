// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/run_control.hpp"
#include "core/second_order_mesh.hpp"
#include "core/tet_mesh.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// f at the points of a mesh, in each of the materials that meet there.
class NodeFractions {
 public:
  /// Of the corners: point i of `mesh` is the vertex order[i] of `state`.
  NodeFractions(const MeshState& state, const TetMesh& mesh, const std::vector<int>& order);

  /// Evaluates f at the nodes 4 to 9 of each tetrahedron, too.
  void add_middle_nodes(const MeshState& state, const SecondOrderMesh& mesh, RunControl& control);

  /// At each point, in the lowest solid there.
  std::vector<double> at_points() const;

  /// At the nodes of tetrahedron t in its own solid.
  template <std::size_t kNodes>
  std::array<double, kNodes> at_tet(const std::array<std::int32_t, kNodes>& nodes, std::size_t t) const {
    std::array<double, kNodes> result;
    for (std::size_t k = 0; k < kNodes; ++k) result[k] = values_[materials_[t]][nodes[k]];
    return result;
  }

 private:
  std::vector<int> materials_;               // of each tetrahedron
  std::vector<int> solids_;                  // of each tetrahedron
  std::vector<int> first_material_;          // of each point: that of its lowest solid
  std::vector<std::vector<double>> values_;  // of each material at each point; NaN where it is not
};

}  // namespace fgmesh
