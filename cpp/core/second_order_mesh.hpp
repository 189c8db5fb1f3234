// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/tet_mesh.hpp"

namespace fgmesh {

/// The edges that the nodes 4 to 9 of a ten-node tetrahedron stand on, in the order of VTK. The first three
/// are those of the nodes 3 to 5 of a six-node triangle.
inline constexpr int kMiddleEdges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};

/// A TetMesh with one more node on each of its edges, shared by all that have the edge. The points of the
/// TetMesh come first, and so do the corners in each row; tetrahedra, triangles and edges keep their order.
struct SecondOrderMesh {
  std::vector<Vec3> points;       ///< mm
  std::vector<Carrier> carriers;  ///< of each point
  std::vector<std::array<std::int32_t, 10>> tets;
  std::vector<std::array<std::int32_t, 6>> triangles;
  std::vector<std::array<std::int32_t, 3>> edges;
  /// Middle nodes of boundary edges that are not on the true boundary, since a tetrahedron would be turned
  /// over there: the edge is straight, or half as curved as it should be.
  std::vector<std::int32_t> straightened;
};

}  // namespace fgmesh
