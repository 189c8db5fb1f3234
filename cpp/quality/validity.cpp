// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/validity.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <sstream>

#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

using Triangle = std::array<std::int32_t, 3>;

/// Sorted vertices, and whether sorting kept the sense of rotation.
std::pair<Triangle, bool> sorted_triangle(Triangle t) {
  bool even = true;
  const auto order = [&](int i, int j) {
    if (t[i] > t[j]) {
      std::swap(t[i], t[j]);
      even = !even;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {t, even};
}

struct Side {
  Triangle vertex;
  std::int32_t tet;
  bool even;
};

template <class... Words>
std::string say(const Words&... words) {
  std::ostringstream text;
  (text << ... << words);
  return text.str();
}

std::string find_point_fault(const TetMesh& mesh) {
  std::vector<char> used(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const std::int32_t v : mesh.tets[t]) {
      if (v < 0 || v >= static_cast<std::int32_t>(mesh.points.size()))
        return say("tetrahedron ", t, " has the point ", v, ", which does not exist");
      used[v] = 1;
    }
  }
  const auto stray = std::find(used.begin(), used.end(), 0);
  if (stray != used.end()) return say("point ", stray - used.begin(), " belongs to no tetrahedron");
  std::vector<std::array<double, 3>> places;
  for (const Vec3& p : mesh.points) {
    if (!p.allFinite()) return "a point is not finite";
    places.push_back({p.x(), p.y(), p.z()});
  }
  std::sort(places.begin(), places.end());
  if (std::adjacent_find(places.begin(), places.end()) != places.end()) return "two points coincide";
  return {};
}

std::string find_label_fault(const TetMesh& mesh) {
  if (mesh.tet_solids.size() != mesh.tets.size()) return "not every tetrahedron has a solid";
  if (mesh.triangle_faces.size() != mesh.triangles.size()) return "not every triangle has a face";
  if (mesh.edge_edges.size() != mesh.edges.size()) return "not every edge has a number";
  if (mesh.carriers.size() != mesh.points.size()) return "not every point has a carrier";
  for (const std::int32_t solid : mesh.tet_solids)
    if (solid < 1) return "a tetrahedron belongs to no solid";
  for (const std::int32_t face : mesh.triangle_faces)
    if (face < 1) return "a triangle belongs to no face";
  return {};
}

}  // namespace

std::string find_fault(const TetMesh& mesh) {
  if (mesh.tets.empty()) return "the mesh has no tetrahedra";
  if (std::string fault = find_point_fault(mesh); !fault.empty()) return fault;
  if (std::string fault = find_label_fault(mesh); !fault.empty()) return fault;

  std::vector<Side> sides;
  sides.reserve(4 * mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& v = mesh.tets[t];
    if (!(signed_volume(mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]) > 0.0))
      return say("tetrahedron ", t, " is not positively oriented");
    for (const auto& face : kFaceVertices) {
      const auto [vertex, even] = sorted_triangle({v[face[0]], v[face[1]], v[face[2]]});
      sides.push_back({vertex, static_cast<std::int32_t>(t), even});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.vertex < b.vertex; });

  // Triangles that must be labelled: the boundary and faces between two solids.
  std::vector<std::pair<Triangle, bool>> boundary;
  std::vector<Triangle> interfaces;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].vertex == sides[i].vertex) ++j;
    if (j - i > 2) return say("a face belongs to ", j - i, " tetrahedra");
    if (j - i == 1) {
      boundary.emplace_back(sides[i].vertex, sides[i].even);
    } else {
      if (sides[i].even == sides[i + 1].even) return "two tetrahedra lie on the same side of a face";
      if (mesh.tet_solids[sides[i].tet] != mesh.tet_solids[sides[i + 1].tet])
        interfaces.push_back(sides[i].vertex);
    }
    i = j;
  }

  std::set<Triangle> labelled;
  std::size_t outward = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto key = sorted_triangle(triangle);
    if (!labelled.insert(key.first).second) return "a labelled triangle stands twice";
    outward += std::binary_search(boundary.begin(), boundary.end(), key);
  }
  if (outward != boundary.size())
    return say(boundary.size() - outward,
               " boundary facets are not among the labelled triangles (or look inward)");
  for (const Triangle& triangle : interfaces)
    if (!labelled.count(triangle)) return "a facet between two solids has no label";
  if (labelled.size() != boundary.size() + interfaces.size())
    return "a labelled triangle lies inside a solid";

  std::set<std::pair<std::int32_t, std::int32_t>> mesh_edges;
  for (const Triangle& t : labelled) mesh_edges.insert({{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}});
  for (const auto& [a, b] : mesh.edges)
    if (!mesh_edges.count({std::min(a, b), std::max(a, b)}))
      return "an edge of the shape leaves the boundary facets";
  return {};
}

}  // namespace fgmesh
