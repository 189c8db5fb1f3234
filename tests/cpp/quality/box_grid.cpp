// SPDX-License-Identifier: GPL-3.0-or-later
#include "box_grid.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace fgmesh::test {
namespace {

// Outward for a positive tetrahedron: without the i-th vertex, in this order.
constexpr int kSides[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

void add_cell(TetMesh& mesh, const std::array<int, 8>& corner, int solid) {
  std::array<int, 3> axes = {0, 1, 2};
  do {  // a way from corner 000 to corner 111 along the axes in this order
    const int first = 1 << axes[0], second = first | 1 << axes[1];
    std::array<std::int32_t, 4> tet = {corner[0], corner[first], corner[second], corner[7]};
    const bool even = (axes[1] - axes[0] + 3) % 3 == 1;
    if (!even) std::swap(tet[1], tet[2]);
    mesh.tets.push_back(tet);
    mesh.tet_solids.push_back(solid);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

/// Number of the face that holds all three points; 0: none.
int common_face(const Box& box, const std::array<Vec3, 3>& points) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, 1}) {
      const double place = side ? box.high[axis] : box.low[axis];
      if (std::all_of(points.begin(), points.end(), [&](const Vec3& p) { return p[axis] == place; }))
        return 1 + 2 * axis + side;
    }
  }
  return 0;
}

void add_triangles(TetMesh& mesh, const Box& box, int solids) {
  const double middle = 0.5 * (box.low.x() + box.high.x());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const auto& side : kSides) {
      const auto& v = mesh.tets[t];
      const std::array<std::int32_t, 3> triangle = {v[side[0]], v[side[1]], v[side[2]]};
      const std::array<Vec3, 3> p = {mesh.points[triangle[0]], mesh.points[triangle[1]],
                                     mesh.points[triangle[2]]};
      int face = common_face(box, p);
      const bool on_interface = p[0].x() == middle && p[1].x() == middle && p[2].x() == middle;
      if (solids == 2 && mesh.tet_solids[t] == 1 && on_interface) face = 7;
      if (!face) continue;
      mesh.triangles.push_back(triangle);
      mesh.triangle_faces.push_back(face);
    }
  }
}

void add_edges(TetMesh& mesh, const Box& box) {
  std::set<std::pair<std::int32_t, std::int32_t>> seen;
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = triangle[k], b = triangle[(k + 1) % 3];
      const Carrier middle = carrier_in_box(box, 0.5 * (mesh.points[a] + mesh.points[b]));
      if (middle.dimension != 1 || !seen.insert({std::min(a, b), std::max(a, b)}).second) continue;
      mesh.edges.push_back({a, b});
      mesh.edge_edges.push_back(middle.number);
    }
  }
}

}  // namespace

Carrier carrier_in_box(const Box& box, const Vec3& p) {
  int fixed = 0, vertex = 0, face = 0, free_axis = 0, sides = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool high = p[axis] == box.high[axis];
    if (!high && p[axis] != box.low[axis]) {
      free_axis = axis;
      continue;
    }
    ++fixed;
    face = 1 + 2 * axis + high;
    sides = 2 * sides + high;
    vertex = sides;
  }
  switch (fixed) {
    case 3:
      return {0, 1 + vertex};
    case 2:
      return {1, 1 + 4 * free_axis + sides};
    case 1:
      return {2, face};
    default:
      return {3, 1};
  }
}

TetMesh box_grid(const Box& box, const std::array<int, 3>& cells, int solids) {
  TetMesh mesh;
  const auto number = [&](int i, int j, int k) { return (i * (cells[1] + 1) + j) * (cells[2] + 1) + k; };
  for (int i = 0; i <= cells[0]; ++i) {
    for (int j = 0; j <= cells[1]; ++j) {
      for (int k = 0; k <= cells[2]; ++k) {
        Vec3 p;
        const std::array<int, 3> index = {i, j, k};
        for (int axis = 0; axis < 3; ++axis) {
          const double s = static_cast<double>(index[axis]) / cells[axis];
          p[axis] = index[axis] == cells[axis] ? box.high[axis]
                                               : box.low[axis] + s * (box.high[axis] - box.low[axis]);
        }
        mesh.points.push_back(p);
        mesh.carriers.push_back(carrier_in_box(box, p));
      }
    }
  }
  for (int i = 0; i < cells[0]; ++i) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int k = 0; k < cells[2]; ++k) {
        std::array<int, 8> corner;
        for (int c = 0; c < 8; ++c) corner[c] = number(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1));
        add_cell(mesh, corner, solids == 2 && 2 * i >= cells[0] ? 2 : 1);
      }
    }
  }
  add_triangles(mesh, box, solids);
  add_edges(mesh, box);
  return mesh;
}

}  // namespace fgmesh::test
