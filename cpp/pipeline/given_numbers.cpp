// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/given_numbers.hpp"

#include <array>

namespace fgmesh {
namespace {

constexpr std::array<const char*, 4> kWords = {"Vertex", "Edge", "Face", "Solid"};

std::int32_t lowest(const std::vector<int>& numbers) { return numbers.empty() ? 0 : numbers.front(); }

std::int32_t given_number(const Carrier& part, const Origins& origins) {
  const std::size_t place = part.number - 1;
  if (origins.solids.empty()) return part.number;
  if (part.dimension == 3) return origins.solids[place];
  return lowest(part.dimension == 2   ? origins.faces[place]
                : part.dimension == 1 ? origins.edges[place]
                                      : origins.vertices[place]);
}

}  // namespace

std::string given_name(const Carrier& part, const Origins& origins) {
  const std::int32_t number = given_number(part, origins);
  if (number > 0) return kWords[part.dimension] + std::to_string(number);
  return part.dimension == 0 ? "a vertex where solids were separated" : "an edge where solids were separated";
}

void use_given_numbers(MeshingResult& result, const Origins& origins) {
  if (origins.solids.empty()) return;
  TetMesh& mesh = result.mesh;
  for (std::int32_t& solid : mesh.tet_solids) solid = origins.solids[solid - 1];
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::vector<int>& faces = origins.faces[mesh.triangle_faces[i] - 1];
    mesh.triangle_faces[i] = lowest(faces);
    for (std::size_t k = 1; k < faces.size(); ++k)
      result.coincident_faces.push_back({static_cast<std::int32_t>(i), faces[k]});
  }
  for (std::int32_t& edge : mesh.edge_edges) edge = lowest(origins.edges[edge - 1]);
  for (std::vector<Carrier>* carriers : {&mesh.carriers, &result.second_order.carriers})
    for (Carrier& carrier : *carriers) carrier.number = given_number(carrier, origins);
}

}  // namespace fgmesh
