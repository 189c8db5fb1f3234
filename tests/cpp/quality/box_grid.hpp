// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/tet_mesh.hpp"

namespace fgmesh::test {

/// What of a box carries a point on it. Faces 1 to 6: x low, x high, y low, y high, z low, z high. Edge
/// 1 + 4 a + 2 s + t runs along axis a, with s and t telling which side (0 low, 1 high) the other two axes
/// are on, in their order; vertex 1 + 4 s + 2 t + u likewise.
Carrier carrier_in_box(const Box& box, const Vec3& p);

/// A box of cells, each cut into the six tetrahedra around its diagonal (Kuhn 1960), labelled and with crease
/// edges. Where `solids` is 2 the box is split into two at half its x by an interface with face number 7.
TetMesh box_grid(const Box& box, const std::array<int, 3>& cells, int solids = 1);

inline TetMesh box_grid(double side, int cells, int solids = 1) {
  return box_grid({Vec3::Zero(), Vec3::Constant(side)}, {cells, cells, cells}, solids);
}

}  // namespace fgmesh::test
