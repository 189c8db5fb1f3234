// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/steiner_points.hpp"

#include "mesh/edge_split.hpp"

namespace fgmesh {
namespace {

/// The edge of tetrahedron t along which the composition varies most and can be split: not across a jump, not
/// below MeshState::min_size. Its two vertices, or {-1, -1}.
std::array<int, 2> steepest_edge(const MeshState& state, int t) {
  const std::array<int, 4>& v = state.complex.tet(t).vertex;
  const int material = state.material(t);
  std::array<int, 2> best = {-1, -1};
  double largest = 0.0;
  bool is_barred = false;  // one with more of the variation
  for (const auto& edge : kEdgeVertices) {
    const Vertex &a = state.vertices[v[edge[0]]], &b = state.vertices[v[edge[1]]];
    const Vec3 way = b.position - a.position;
    const MaterialValue &at_a = a.in(material), &at_b = b.in(material);
    const double change = difference(at_a.composition, at_b.composition);
    if (change <= largest) continue;
    const bool is_above = change > state.threshold();
    if (way.norm() < 2.0 * state.min_size ||
        (is_above && is_sudden(at_a, at_b, way, state.threshold()) &&
         jumps_between(state.materials().field(material), a.position, b.position, state.threshold()))) {
      is_barred |= is_above;
      continue;
    }
    largest = change;
    best = {v[edge[0]], v[edge[1]]};
  }
  // What little f changes along the other edges is no reason to split these, again and again.
  return is_barred && largest <= state.threshold() ? std::array<int, 2>{-1, -1} : best;
}

/// A new point on the inner edge (a, b) would come close to boundary facets around it that are coarser than
/// the mesh inside; then the longest edge of such a facet is to be split first (Delaunay refinement calls the
/// facet encroached upon). Changes (a, b) and t to that edge and a tetrahedron that has it.
void yield_to_boundary(const MeshState& state, int& a, int& b, int& t) {
  EdgeRing ring;
  state.complex.ring(a, b, t, ring);
  if (state.label_at(a, b, ring)) return;
  const Vec3 middle = 0.5 * (state.position(a) + state.position(b));
  double longest = (state.position(a) - state.position(b)).norm();
  const std::vector<int> around = ring.tet;
  for (int near : around) {
    const Tet& tet = state.complex.tet(near);
    for (int i = 0; i < 4; ++i) {
      if (!tet.label[i]) continue;
      const int* face = kFaceVertices[i];
      for (int k = 0; k < 3; ++k) {
        const int p = tet.vertex[face[k]], q = tet.vertex[face[(k + 1) % 3]],
                  r = tet.vertex[face[(k + 2) % 3]];
        const double length = (state.position(p) - state.position(q)).norm();
        const Vec3 centre = (state.position(p) + state.position(q) + state.position(r)) / 3.0;
        if (length <= longest || (middle - centre).norm() > 0.55 * length) continue;
        longest = length;
        a = p;
        b = q;
        t = near;
      }
    }
  }
}

}  // namespace

int insert_steiner_points(MeshState& state, double limit, std::size_t most, RunControl& control) {
  std::vector<std::pair<double, int>> bad;
  for (int t = 0; t < state.complex.slots(); ++t) {
    if (!state.complex.tet(t).alive()) continue;
    const double variation = state.variation(t);
    if (variation > limit) bad.emplace_back(-variation, t);
  }
  std::sort(bad.begin(), bad.end());
  const int old_vertices = state.complex.vertex_slots();
  int inserted = 0;
  for (const auto& [variation, t] : bad) {
    if (static_cast<std::size_t>(inserted) >= most) break;
    if (inserted % 256 == 0) control.check_at(state.position(state.complex.tet(t).vertex[0]));
    const Tet& tet = state.complex.tet(t);
    if (!tet.alive() || !(state.variation(t) > limit)) continue;
    if (*std::max_element(tet.vertex.begin(), tet.vertex.end()) >= old_vertices) continue;
    auto [a, b] = steepest_edge(state, t);
    if (a < 0) continue;
    int at = t;
    yield_to_boundary(state, a, b, at);
    const int v = split_edge(state, a, b, at);
    if (v >= 0) ++inserted;
  }
  return inserted;
}

int count_above(const MeshState& state, double limit) {
  int count = 0;
  for (int t = 0; t < state.complex.slots(); ++t)
    count += state.complex.tet(t).alive() && state.variation(t) > limit;
  return count;
}

int count_divisible(const MeshState& state, double limit) {
  int count = 0;
  for (int t = 0; t < state.complex.slots(); ++t)
    count += state.complex.tet(t).alive() && state.variation(t) > limit && steepest_edge(state, t)[0] >= 0;
  return count;
}

bool is_sudden(const MaterialValue& a, const MaterialValue& b, const Vec3& way, double threshold) {
  const double foretold =
      std::max(magnitude(change_along(a.gradient, way)), magnitude(change_along(b.gradient, way)));
  return difference(a.composition, b.composition) > 3.0 * foretold + 0.5 * threshold;
}

bool jumps_between(const CompositionField& field, Vec3 p, Vec3 q, double threshold) {
  constexpr int kHalvings = 30;
  const auto at = [&](const Vec3& place) {
    Composition result(field.constituents() - 1);
    field.evaluate(&place, 1, result.data());
    return result;
  };
  Composition at_p = at(p), at_q = at(q);
  for (int i = 0; i < kHalvings; ++i) {
    const Vec3 middle = 0.5 * (p + q);
    const Composition between = at(middle);
    if (difference(between, at_p) > difference(between, at_q)) {
      q = middle;
      at_q = between;
    } else {
      p = middle;
      at_p = between;
    }
    if (!(difference(at_p, at_q) > threshold)) return false;
  }
  return true;
}

}  // namespace fgmesh
