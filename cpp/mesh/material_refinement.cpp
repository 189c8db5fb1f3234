// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/material_refinement.hpp"

#include "mesh/edge_collapse.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/odt_smoothing.hpp"
#include "mesh/swap.hpp"
#include "mesh/threshold_relaxation.hpp"
#include "mesh/worst_first.hpp"
#include <cstdio>
#include <cstdlib>

namespace fgmesh {
namespace {

/// The edge of tetrahedron t along which f varies most and can be split: not across a jump, not below min_size.
/// Its two vertices, or {-1, -1}.
std::array<int, 2> steepest_edge(const MeshState& state, int t, double min_size) {
  const std::array<int, 4>& v = state.complex.tet(t).vertex;
  std::array<int, 2> best = {-1, -1};
  double largest = 0.0;
  for (const auto& edge : kEdgeVertices) {
    const Vertex &a = state.vertices[v[edge[0]]], &b = state.vertices[v[edge[1]]];
    const Vec3 way = b.position - a.position;
    const double length = way.norm(), difference = std::abs(b.value - a.value);
    if (difference <= largest || length < 2.0 * min_size) continue;
    if (difference > state.threshold()) {
      const double foretold = std::max(std::abs(a.gradient.dot(way)), std::abs(b.gradient.dot(way)));
      // Far more than the gradient foretells: a jump, or a steep layer between the two.
      if (difference > 3.0 * foretold + 0.5 * state.threshold() &&
          jumps_between(state.field(), a.position, b.position, state.threshold()))
        continue;
    }
    largest = difference;
    best = {v[edge[0]], v[edge[1]]};
  }
  return best;
}

/// A new point on the inner edge (a, b) would come close to boundary facets around it that are coarser than the mesh inside;
/// then the longest edge of such a facet is to be split first (Delaunay refinement calls the facet encroached upon). Changes (a, b)
/// and t to that edge and a tetrahedron that has it.
void yield_to_boundary(const MeshState& state, int& a, int& b, int& t) {
  EdgeRing ring;
  state.complex.ring(a, b, t, ring);
  if (state.label_at(a, b, ring)) return;
  const Vec3 middle = 0.5 * (state.position(a) + state.position(b));
  double longest = 0.0;
  const std::vector<int> around = ring.tet;
  for (int near : around) {
    const Tet& tet = state.complex.tet(near);
    for (int i = 0; i < 4; ++i) {
      if (!tet.label[i]) continue;
      const int* face = kFaceVertices[i];
      for (int k = 0; k < 3; ++k) {
        const int p = tet.vertex[face[k]], q = tet.vertex[face[(k + 1) % 3]], r = tet.vertex[face[(k + 2) % 3]];
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

/// A Steiner point into every tetrahedron above `limit` that no other Steiner point of this round touches,
/// worst first, at most `most` of them. Returns how many.
int insert_steiner_points(MeshState& state, double limit, const SizingField& sizing, std::size_t most, RunControl& control) {
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
    if (inserted % 256 == 0) control.check();
    const Tet& tet = state.complex.tet(t);
    if (!tet.alive() || !(state.variation(t) > limit)) continue;
    if (*std::max_element(tet.vertex.begin(), tet.vertex.end()) >= old_vertices) continue;
    auto [a, b] = steepest_edge(state, t, sizing.min_size);
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

double env(const char* n, double d) { const char* e = getenv(n); return e ? atof(e) : d; }

void dump(const MeshState& state, const char* what) {
  if (!getenv("FG_DUMP")) return;
  double lo = 180, hi = 0, mean = 0, mx = 0; int n = 0, above = 0;
  for (int t = 0; t < state.complex.slots(); ++t) {
    const Tet& tet = state.complex.tet(t);
    if (!tet.alive()) continue;
    const auto& v = tet.vertex;
    AngleRange r = dihedral_range(state.position(v[0]), state.position(v[1]), state.position(v[2]), state.position(v[3]));
    lo = std::min(lo, r.smallest); hi = std::max(hi, r.largest);
    double d = state.variation(t); mean += d; mx = std::max(mx, d); above += d > state.threshold(); ++n;
  }
  fprintf(stderr, "%-12s tets %7d above %6d max %.4f mean %.4f angles %.2f %.2f  t=%.2f\n", what, n, above, mx, mean / n, lo, hi, clock() / 1e6);
  if (getenv("FG_CHECK")) {
    std::vector<std::array<int,3>> f;
    for (int t = 0; t < state.complex.slots(); ++t) if (state.complex.tet(t).alive()) for (auto& k : kFaceVertices) { auto& q = state.complex.tet(t).vertex; std::array<int,3> a{q[k[0]],q[k[1]],q[k[2]]}; std::sort(a.begin(),a.end()); f.push_back(a); }
    std::sort(f.begin(), f.end());
    for (size_t i = 2; i < f.size(); ++i) if (f[i] == f[i-2]) { fprintf(stderr, "BROKEN face %d %d %d\n", f[i][0], f[i][1], f[i][2]); 
      for (int v : f[i]) { auto& x = state.vertices[v]; fprintf(stderr, "   %d (%.4f %.4f %.4f) dim %d #%d\n", v, x.position.x(), x.position.y(), x.position.z(), x.carrier.dimension, x.carrier.number); }
      for (int t = 0; t < state.complex.slots(); ++t) { auto& T = state.complex.tet(t); if (T.alive() && T.has(f[i][0]) && T.has(f[i][1]) && T.has(f[i][2])) { fprintf(stderr, "   tet %d: %d %d %d %d\n", t, T.vertex[0], T.vertex[1], T.vertex[2], T.vertex[3]); for (int v : T.vertex) { auto& x = state.vertices[v]; fprintf(stderr, "      %d (%.4f %.4f %.4f) dim %d #%d\n", v, x.position.x(), x.position.y(), x.position.z(), x.carrier.dimension, x.carrier.number);} } }
      exit(1); }
  }
  if (getenv("FG_WORST")) {
    std::vector<std::pair<double,int>> w;
    for (int t = 0; t < state.complex.slots(); ++t) if (state.complex.tet(t).alive()) w.push_back({-state.variation(t), t});
    std::sort(w.begin(), w.end());
    for (int i = 0; i < 4; ++i) { const Tet& tet = state.complex.tet(w[i].second); fprintf(stderr, "  worst %.3f\n", -w[i].first);
      for (int k = 0; k < 4; ++k) { const Vertex& x = state.vertices[tet.vertex[k]]; fprintf(stderr, "    %d (%.3f %.3f %.3f) dim %d #%d f %.3f g %.3f label %d\n", tet.vertex[k], x.position.x(), x.position.y(), x.position.z(), x.carrier.dimension, x.carrier.number, x.value, x.gradient.norm(), tet.label[k]); } }
  }
}

}  // namespace

bool jumps_between(const ScalarField& field, Vec3 p, Vec3 q, double threshold) {
  constexpr int kHalvings = 30;
  double values[2];
  const Vec3 ends[2] = {p, q};
  field.evaluate(ends, 2, values);
  for (int i = 0; i < kHalvings; ++i) {
    const Vec3 middle = 0.5 * (p + q);
    double value;
    field.evaluate(&middle, 1, &value);
    if (std::abs(value - values[0]) > std::abs(values[1] - value)) {
      q = middle;
      values[1] = value;
    } else {
      p = middle;
      values[0] = value;
    }
    if (!(std::abs(values[1] - values[0]) > threshold)) return false;
  }
  return true;
}

void refine_material(MeshState& state, const MaterialRefinementOptions& options, RunControl& control) {
  const double threshold = state.threshold();
  const double growth_limit = env("FG_LIMIT", options.growth_limit);
  const int growth_sweeps = env("FG_GS", options.growth_sweeps), final_sweeps = env("FG_FS", options.final_sweeps), relaxations = env("FG_RX", options.relaxations);
  const double aim = env("FG_AIM", options.relaxation_aim);
  const auto smooth = [&](int sweeps, double damping) {
    for (int i = 0; i < sweeps; ++i) {
      update_sizes(state, options.sizing);
      odt_sweep(state, damping, control);
    }
  };
  dump(state, "start");
  smooth(3, 1.0);
  dump(state, "odt");
  for (int round = 0; round < 60; ++round) {
    resolve_boundary(state, options.sizing.min_size, control);
    const int inserted = insert_steiner_points(state, growth_limit * threshold, options.sizing, options.most_tets, control);
    if (inserted == 0) break;
    smooth(growth_sweeps, 1.0);
    dump(state, "grow");
  }
  smooth(final_sweeps, 1.0);
  dump(state, "final odt");

  const TetScore score(state, options.goal);
  WorstFirst mender(state, score);
  for (int round = 0; round < 30; ++round) {
    for (int i = 0; i < relaxations; ++i) {
      if (i % 15 == 14) smooth(1, 0.5);
      relax_threshold(state, aim * threshold, control);
    }
    dump(state, "relax");
    const int left = mender.run(2, control);
    dump(state, "mend");
    const int above = count_above(state, threshold);
    if (above == 0 && left == 0) break;
    if (above > 0) insert_steiner_points(state, threshold, options.sizing, std::max(8, above / 4), control);
    else break;
  }
  mender.run(10, control);
  dump(state, "end");
}

}  // namespace fgmesh
