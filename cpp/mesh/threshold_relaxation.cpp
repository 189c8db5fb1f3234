// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/threshold_relaxation.hpp"

#include "mesh/blocks.hpp"
#include "mesh/steiner_points.hpp"
#include "mesh/stretch.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {
namespace {

/// What the tetrahedra ask of a vertex.
struct Request {
  Vec3 way = Vec3::Zero();
  int count = 0;
};

/// What one tetrahedron asks of the two of its vertices that are farthest apart: to move towards each other.
struct Pull {
  std::array<int, 2> vertex{-1, -1};  // -1: nothing
  std::array<Vec3, 2> way;
  bool above = false;  // the threshold
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

Pull pull_of(const MeshState& state, int t, double aim) {
  Pull pull;
  const Tet& tet = state.complex.tet(t);
  if (!tet.alive()) return pull;
  const int material = state.material(t);
  const auto [a, b] = farthest_apart(state, tet, material);
  const Composition &from = state.vertices[a].in(material).composition,
                    &to = state.vertices[b].in(material).composition;
  const double variation = difference(from, to);
  pull.above = variation > state.threshold();
  if (variation <= aim) return pull;
  const Vec3 apart = state.position(b) - state.position(a);
  // No move mends these; they would only draw ever more vertices into a jump, or a layer steeper than MinSize
  // lets be followed.
  if (is_sudden(state.vertices[a].in(material), state.vertices[b].in(material), apart, state.threshold()) ||
      (variation > kBeyondMoves * state.threshold() && apart.norm() < 2.0 * state.min_size))
    return pull;
  const double longest = 0.2 * apart.norm();
  for (int i = 0; i < 2; ++i) {
    const int v = i == 0 ? a : b;
    const Vec3 gradient = gradient_towards(state.vertices[v].in(material).gradient, from, to);
    const double slope = gradient.norm();
    if (!(slope > 0.0)) continue;
    const double step = std::min(longest, 0.5 * (variation - aim) / slope);
    pull.vertex[i] = v;
    pull.way[i] = (i == 0 ? step : -step) / slope * gradient;
  }
  return pull;
}

std::vector<Request> gather(const MeshState& state, double aim, int& above) {
  std::vector<Pull> pulls(state.complex.slots());
  for_ranges_at_once(pulls.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) pulls[t] = pull_of(state, static_cast<int>(t), aim);
  });
  std::vector<Request> requests(state.vertices.size());
  above = 0;
  for (const Pull& pull : pulls) {
    above += pull.above;
    for (int i = 0; i < 2; ++i) {
      if (pull.vertex[i] < 0) continue;
      requests[pull.vertex[i]].way += pull.way[i];
      ++requests[pull.vertex[i]].count;
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
  sweep_vertices(state, control, [&](int v, std::vector<int>& star) {
    const Vertex& vertex = state.vertices[v];
    if (requests[v].count == 0 || vertex.is_fixed()) return;
    state.complex.star(v, star);
    const StarState before = star_state(state, v, vertex, star);
    const Vec3 way = requests[v].way / requests[v].count;
    for (double part = 1.0; part > 0.2; part *= 0.5) {
      const std::optional<Vertex> moved = state.moved(vertex, vertex.position + part * way);
      if (!moved || !may_move(state, v, *moved, star)) continue;
      const StarState after = star_state(state, v, *moved, star);
      if (after.flatness <= std::min(kFlat, before.flatness)) continue;
      if (after.variation > std::max(before.variation, state.threshold())) continue;
      state.vertices[v] = *moved;
      break;
    }
  });
  return above;
}

}  // namespace fgmesh
