// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/threshold_relaxation.hpp"

#include "mesh/stretch.hpp"

namespace fgmesh {
namespace {

struct Request {
  Vec3 way = Vec3::Zero();
  int count = 0;
};

/// The two vertices between which the composition differs most.
std::array<int, 2> farthest_apart(const MeshState& state, const Tet& tet, int material) {
  std::array<int, 2> result{};
  double largest = -1.0;
  for (const auto& [i, j] : kEdgeVertices) {
    const int a = tet.vertex[i], b = tet.vertex[j];
    const double apart =
        difference(state.vertices[a].in(material).composition, state.vertices[b].in(material).composition);
    if (apart <= largest) continue;
    largest = apart;
    result = {a, b};
  }
  return result;
}

std::vector<Request> gather(const MeshState& state, double aim, int& above) {
  std::vector<Request> requests(state.vertices.size());
  above = 0;
  for (int t = 0; t < state.complex.slots(); ++t) {
    const Tet& tet = state.complex.tet(t);
    if (!tet.alive()) continue;
    const int material = state.material(t);
    const auto [a, b] = farthest_apart(state, tet, material);
    const Composition &from = state.vertices[a].in(material).composition,
                      &to = state.vertices[b].in(material).composition;
    const double variation = difference(from, to);
    if (variation > state.threshold()) ++above;
    if (variation <= aim) continue;
    for (const int v : {a, b}) {
      const Vec3 gradient = gradient_towards(state.vertices[v].in(material).gradient, from, to);
      const double slope = gradient.norm();
      if (!(slope > 0.0)) continue;
      const double longest = 0.2 * (state.position(b) - state.position(a)).norm();
      const double step = std::min(longest, 0.5 * (variation - aim) / slope);
      requests[v].way += (v == a ? step : -step) / slope * gradient;
      ++requests[v].count;
    }
  }
  return requests;
}

/// Worst flatness and largest variation of a star with v imagined elsewhere.
struct StarState {
  double flatness = 1.0;
  double variation = 0.0;
};

StarState star_state(const MeshState& state, int v, const Vertex& moved, const std::vector<int>& star) {
  StarState result;
  for (int t : star) {
    const std::array<int, 4>& index = state.complex.tet(t).vertex;
    const auto at = [&](int i) -> const Vertex& { return index[i] == v ? moved : state.vertices[index[i]]; };
    result.flatness = std::min(result.flatness, StretchedTet(at(0), at(1), at(2), at(3)).flatness());
    result.variation = std::max(result.variation, variation(at(0), at(1), at(2), at(3)));
  }
  return result;
}

}  // namespace

int relax_threshold(MeshState& state, double aim, RunControl& control) {
  constexpr double kFlat = 4e-3;  // a regular tetrahedron has 0.048
  int above = 0;
  const std::vector<Request> requests = gather(state, aim, above);
  std::vector<int> star;
  for (int v = 0; v < state.complex.vertex_slots(); ++v) {
    if (v % 512 == 0) control.check();
    const Vertex& vertex = state.vertices[v];
    if (requests[v].count == 0 || state.complex.tet_at(v) < 0 || vertex.is_fixed()) continue;
    state.complex.star(v, star);
    const StarState before = star_state(state, v, vertex, star);
    const Vec3 way = requests[v].way / requests[v].count;
    for (double part = 1.0; part > 0.2; part *= 0.5) {
      const std::optional<Vertex> moved = state.moved(vertex, vertex.position + part * way);
      if (!moved || !keeps_surface(state, v, *moved, star)) continue;
      const StarState after = star_state(state, v, *moved, star);
      if (after.flatness <= std::min(kFlat, before.flatness)) continue;
      if (after.variation > std::max(before.variation, state.threshold())) continue;
      state.vertices[v] = *moved;
      break;
    }
  }
  return above;
}

}  // namespace fgmesh
