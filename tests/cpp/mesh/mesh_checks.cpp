// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_checks.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "quality/mesh_statistics.hpp"
#include "quality/validity.hpp"

namespace fgmesh::test {
namespace {

template <class... Words>
std::string say(const Words&... words) {
  std::ostringstream text;
  (text << ... << words);
  return text.str();
}

std::set<int> face_vertices(const Tet& tet, int face) {
  std::set<int> found(tet.vertex.begin(), tet.vertex.end());
  found.erase(tet.vertex[face]);
  return found;
}

std::string find_neighbour_fault(const TetComplex& complex, int t) {
  const Tet& tet = complex.tet(t);
  for (int i = 0; i < 4; ++i) {
    const int other = tet.neighbour[i];
    if (other < 0) {
      if (!tet.label[i]) return say("face ", i, " of tet ", t, " bounds the mesh without a label");
      continue;
    }
    if (other >= complex.slots() || !complex.tet(other).alive())
      return say("tet ", t, " has the neighbour ", other, ", which is not there");
    const Tet& beyond = complex.tet(other);
    const auto back = std::find(beyond.neighbour.begin(), beyond.neighbour.end(), t);
    if (back == beyond.neighbour.end()) return say("tet ", other, " does not know its neighbour ", t);
    const auto face = static_cast<int>(back - beyond.neighbour.begin());
    if (face_vertices(tet, i) != face_vertices(beyond, face))
      return say("tets ", t, " and ", other, " are neighbours across different faces");
    if (beyond.label[face] != tet.label[i])
      return say("tets ", t, " and ", other, " label a face differently");
    if ((tet.solid != beyond.solid) != (tet.label[i] != 0))
      return say("the face between tets ", t, " and ", other, " is wrongly labelled");
  }
  return {};
}

std::string find_vertex_fault(const TetComplex& complex) {
  std::map<int, std::set<int>> around;
  for (int t = 0; t < complex.slots(); ++t)
    if (complex.tet(t).alive())
      for (const int v : complex.tet(t).vertex) around[v].insert(t);
  std::vector<int> star;
  for (int v = 0; v < complex.vertex_slots(); ++v) {
    complex.star(v, star);
    if (!around.count(v)) {
      if (complex.tet_at(v) >= 0 || !star.empty()) return say("vertex ", v, " is unused but has a tet");
      continue;
    }
    if (!around[v].count(complex.tet_at(v))) return say("vertex ", v, " knows no tet of its own");
    if (std::set<int>(star.begin(), star.end()) != around[v] || star.size() != around[v].size())
      return say("the star of vertex ", v, " is not complete");
  }
  return {};
}

std::string find_carrier_fault(const MeshState& state, const AnalyticSolid& solid) {
  const double tolerance = 1e-12 * state.diagonal();
  for (int v = 0; v < state.complex.vertex_slots(); ++v) {
    if (state.complex.tet_at(v) < 0) continue;
    const auto& [dimension, number] = state.vertices[v].carrier;
    const Vec3& p = state.position(v);
    Vec3 nearest = p;
    if (dimension == 0) nearest = solid.vertex_position(number);
    if (dimension == 1) nearest = solid.project_to_edge(number, p).position;
    if (dimension == 2) nearest = solid.project_to_face(number, p).position;
    if ((p - nearest).norm() > tolerance)
      return say("vertex ", v, " is ", (p - nearest).norm(), " mm off the entity of dimension ", dimension,
                 " and number ", number, " that carries it");
    if (dimension == 3 && !solid.contains(p)) return say("vertex ", v, " lies outside the solid");
  }
  return {};
}

std::string find_crease_fault(const MeshState& state, const AnalyticSolid& solid, double tolerance) {
  std::vector<double> length(solid.edge_count() + 1, 0.0);
  for (const auto& [a, b, edge] : state.complex.creases()) {
    if (state.complex.find_edge(a, b) < 0) return say("the crease ", a, "-", b, " is no edge of the mesh");
    if (edge < 1 || edge > solid.edge_count()) return say("there is no edge ", edge);
    length[edge] += (state.position(a) - state.position(b)).norm();
  }
  for (int edge = 1; edge <= solid.edge_count(); ++edge) {
    const double part = length[edge] / solid.edge_length(edge);
    if (part < 1.0 - tolerance || part > 1.0 + 1e-9) return say("edge ", edge, " is covered to ", part);
  }
  return {};
}

}  // namespace

std::string find_fault(const TetComplex& complex) {
  int count = 0;
  for (int t = 0; t < complex.slots(); ++t) {
    if (!complex.tet(t).alive()) continue;
    ++count;
    if (std::string fault = find_neighbour_fault(complex, t); !fault.empty()) return fault;
  }
  if (count != complex.tet_count()) return say(count, " tets are alive, not ", complex.tet_count());
  if (std::string fault = find_vertex_fault(complex); !fault.empty()) return fault;
  for (const auto& [a, b, edge] : complex.creases())
    if (complex.find_edge(a, b) < 0) return say("the crease ", a, "-", b, " is no edge of the mesh");
  return {};
}

std::string find_fault(const MeshState& state, const AnalyticSolid& solid, double crease_tolerance) {
  if (std::string fault = find_fault(state.complex); !fault.empty()) return fault;
  if (std::string fault = fgmesh::find_fault(state.to_tet_mesh()); !fault.empty()) return fault;
  if (std::string fault = find_carrier_fault(state, solid); !fault.empty()) return fault;
  return find_crease_fault(state, solid, crease_tolerance);
}

double volume_of(const MeshState& state) { return volume(state.to_tet_mesh()); }

int vertex_count(const MeshState& state) { return static_cast<int>(state.to_tet_mesh().points.size()); }

double largest_variation(const MeshState& state) {
  double largest = 0.0;
  for (int t = 0; t < state.complex.slots(); ++t)
    if (state.complex.tet(t).alive()) largest = std::max(largest, state.variation(t));
  return largest;
}

AngleRange angle_range(const MeshState& state) {
  AngleRange all{180.0, 0.0};
  for (int t = 0; t < state.complex.slots(); ++t) {
    if (!state.complex.tet(t).alive()) continue;
    const auto& v = state.complex.tet(t).vertex;
    const AngleRange own = dihedral_range(state.position(v[0]), state.position(v[1]), state.position(v[2]),
                                          state.position(v[3]));
    all = {std::min(all.smallest, own.smallest), std::max(all.largest, own.largest)};
  }
  return all;
}

void load(MeshState& state, const TetMesh& mesh, double size) {
  std::vector<NewTet> tets;
  std::vector<LabelledFacet> facets;
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    Vertex vertex;
    vertex.position = mesh.points[v];
    vertex.carrier = mesh.carriers[v];
    vertex.size = size;
    vertex = state.carried(vertex, vertex.position, false);
    state.evaluate(vertex);
    state.vertices.push_back(vertex);
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    tets.push_back({{a, b, c, d}, mesh.tet_solids[t]});
  }
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    facets.push_back({{a, b, c}, mesh.triangle_faces[f]});
  }
  state.complex.build(tets, facets, static_cast<int>(mesh.points.size()));
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    state.complex.set_crease(mesh.edges[e][0], mesh.edges[e][1], mesh.edge_edges[e]);
}

GridMesh::GridMesh(double side_, int cells_, FunctionField material, double threshold)
    : side(side_),
      cells(cells_),
      solid({Vec3::Zero(), Vec3::Constant(side_)}),
      field(std::move(material)),
      state(solid, field, threshold, std::sqrt(3.0) * side_) {
  load(state, box_grid(side, cells), side / cells);
}

void GridMesh::shake(double part, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-part * side / cells, part * side / cells);
  std::vector<int> star;
  for (int v = 0; v < state.complex.vertex_slots(); ++v) {
    const double x = shift(random), y = shift(random), z = shift(random);
    if (state.complex.tet_at(v) < 0) continue;
    state.complex.star(v, star);
    const std::optional<Vertex> moved = state.moved(state.vertices[v], state.position(v) + Vec3(x, y, z));
    if (moved && stays_positive(state, v, moved->position, star)) state.vertices[v] = *moved;
  }
}

}  // namespace fgmesh::test
