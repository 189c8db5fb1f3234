// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/run_control.hpp"
#include "core/second_order_mesh.hpp"
#include "core/tet_mesh.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// The composition at the points of a mesh, in each of the materials that meet there.
class NodeFractions {
 public:
  /// Of the corners: point i of `mesh` is the vertex order[i] of `state`.
  NodeFractions(const MeshState& state, const TetMesh& mesh, const std::vector<int>& order);

  /// Evaluates the materials at the nodes 4 to 9 of each tetrahedron, too.
  void add_middle_nodes(const MeshState& state, const SecondOrderMesh& mesh, RunControl& control);

  /// Constituents of the material that has most.
  int columns() const { return columns_; }

  /// Fractions of all constituents at each point, in the material of the lowest solid there: rows of
  /// columns(), zeros where that material has fewer.
  std::vector<double> at_points() const;

  /// The same at the nodes of each tetrahedron in its own material, node after node.
  template <std::size_t kNodes>
  std::vector<double> at_tets(const std::vector<std::array<std::int32_t, kNodes>>& tets) const {
    std::vector<double> result;
    result.reserve(tets.size() * kNodes * columns_);
    for (std::size_t t = 0; t < tets.size(); ++t)
      for (const std::int32_t node : tets[t]) put_row(materials_[t], node, result);
    return result;
  }

  /// Variation of the composition of each tetrahedron, from its corners.
  std::vector<double> variations(const std::vector<std::array<std::int32_t, 4>>& tets) const;

 private:
  const Composition& at(int material, std::int32_t node) const { return values_[material][node]; }
  void put_row(int material, std::int32_t node, std::vector<double>& rows) const;

  int columns_ = 2;
  std::vector<int> materials_;                    // of each tetrahedron
  std::vector<int> solids_;                       // of each tetrahedron
  std::vector<int> first_material_;               // of each point: that of its lowest solid
  std::vector<std::vector<Composition>> values_;  // of each material at each point; empty where it is not
};

}  // namespace fgmesh
