// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/vec3.hpp"

namespace fgmesh {

/// The B-Rep entity of lowest dimension that carries a mesh vertex: 0 VertexN, 1 EdgeN, 2 FaceN, 3 SolidN.
/// N is 0 for edges and vertices that the shape given has not: where solids had to be separated.
struct Carrier {
  std::int32_t dimension = 3;
  std::int32_t number = 1;
};

/// A finished mesh as plain arrays: what leaves the C++ side.
struct TetMesh {
  std::vector<Vec3> points;                            ///< mm
  std::vector<Carrier> carriers;                       ///< of each point
  std::vector<std::array<std::int32_t, 4>> tets;       ///< positively oriented (VTK order)
  std::vector<std::int32_t> tet_solids;                ///< SolidN
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< boundary and interfaces, outward
  std::vector<std::int32_t> triangle_faces;            ///< FaceN
  std::vector<std::array<std::int32_t, 2>> edges;      ///< mesh edges that follow B-Rep edges
  std::vector<std::int32_t> edge_edges;                ///< EdgeN; 0 as for Carrier
};

}  // namespace fgmesh
