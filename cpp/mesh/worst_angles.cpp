// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/worst_angles.hpp"

#include <algorithm>
#include <vector>

#include "mesh/edge_collapse.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/tet_mender.hpp"

namespace fgmesh {
namespace {

/// Parts of the goal: angles below the first are worth the effort; mending goes on up to the second.
constexpr double kFloor = 0.69, kSettled = 0.85;

using Corners = std::array<int, 4>;

bool same_tet(const Tet& tet, const Corners& corners) {
  return tet.alive() && std::all_of(corners.begin(), corners.end(), [&](int v) { return tet.has(v); });
}

class Rescue {
 public:
  Rescue(MeshState& state, const QualityGoal& goal, RunControl& control)
      : state_(state),
        control_(control),
        score_(state, goal),
        shape_(state, {goal.smallest_angle, goal.largest_angle, false}),
        mender_(state, score_, state.complex.own_site(), 54321) {}

  int run() {
    constexpr int kPasses = 3;
    int rescued = 0, in_vain = 0;
    for (int pass = 0; pass < kPasses; ++pass) {
      const int before = rescued;
      for (const Corners& corners : bad_tets()) {
        if (in_vain >= kMostInVain) return rescued;
        const bool better = rescue(corners);
        rescued += better;
        in_vain = better ? 0 : in_vain + 1;
      }
      if (rescued == before) break;
    }
    return rescued;
  }

 private:
  static constexpr int kSplits = 6, kShakes = 4, kCollapses = 12;
  static constexpr int kMostInVain = 12;  // one after the other: then the shape must be to blame
  static constexpr int kMostBad = 100;    // likewise, where there are more
  static constexpr int kMostMends = 4000;
  static constexpr std::int64_t kMostCopied = 60000000;  // tetrahedra, in all attempts

  struct Verdict {
    double missing = 0.0;  // sum over tetrahedra of what they have less than kFloor
    int above = 0;         // the threshold
  };

  void judge(const Tet& tet, const std::vector<Vertex>& x, Verdict& verdict) const {
    if (!tet.alive()) return;
    const auto& [a, b, c, d] = tet.vertex;
    verdict.missing += std::max(0.0, kFloor - shape_.of(x[a], x[b], x[c], x[d]));
    verdict.above += variation(x[a], x[b], x[c], x[d]) > state_.threshold();
  }

  /// Whether the tetrahedra that are not what they were are better than those that they were.
  bool is_better_than(const TetComplex& complex, const std::vector<Vertex>& vertices) const {
    std::vector<char> moved(state_.vertices.size(), 1);
    for (std::size_t v = 0; v < vertices.size(); ++v)
      moved[v] = vertices[v].position != state_.vertices[v].position;
    Verdict before, after;
    const Tet none;
    for (int t = 0; t < state_.complex.slots(); ++t) {
      const Tet &old = t < complex.slots() ? complex.tet(t) : none, &now = state_.complex.tet(t);
      const auto is_moved = [&](int v) { return moved[v] != 0; };
      if (old.solid == now.solid &&
          (!now.alive() ||
           (old.vertex == now.vertex && std::none_of(now.vertex.begin(), now.vertex.end(), is_moved))))
        continue;
      judge(old, vertices, before);
      judge(now, state_.vertices, after);
    }
    constexpr double kClearly = 0.99;
    return after.missing < kClearly * before.missing && after.above <= before.above;
  }

  /// Whether the two facets at an edge of the shape make the small angle themselves.
  bool is_wedge(const Tet& tet) const {
    const auto at = [&](int i) -> const Vec3& { return state_.position(tet.vertex[i]); };
    const std::array<double, 6> cosines = dihedral_cosines(at(0), at(1), at(2), at(3));
    const int worst = static_cast<int>(std::max_element(cosines.begin(), cosines.end()) - cosines.begin());
    const int* edge = kEdgeVertices[worst];
    const int* beside = kEdgeVertices[5 - worst];
    return tet.label[beside[0]] && tet.label[beside[1]] &&
           state_.complex.crease(tet.vertex[edge[0]], tet.vertex[edge[1]]) != 0;
  }

  /// Worst first; none where there are so many that the shape must be to blame.
  std::vector<Corners> bad_tets() const {
    std::vector<std::pair<double, int>> found;
    const TetComplex& complex = state_.complex;
    for (int t = 0; t < complex.slots(); ++t) {
      const Tet& tet = complex.tet(t);
      if (!tet.alive()) continue;
      const double score = shape_(t);
      if (score < kFloor && !is_wedge(tet)) found.push_back({score, t});
    }
    if (found.size() > kMostBad) return {};
    std::sort(found.begin(), found.end());
    std::vector<Corners> tets;
    for (const auto& [score, t] : found) tets.push_back(complex.tet(t).vertex);
    return tets;
  }

  int find(const Corners& corners) const {
    std::vector<int> star;
    for (int v : corners)
      if (state_.complex.tet_at(v) < 0) return -1;
    state_.complex.star(corners[0], star);
    for (int t : star)
      if (same_tet(state_.complex.tet(t), corners)) return t;
    return -1;
  }

  bool rescue(const Corners& corners) {
    const int t = find(corners);
    if (t < 0 || shape_(t) >= kFloor) return false;
    const TetComplex complex = state_.complex;
    const std::vector<Vertex> vertices = state_.vertices;
    for (int attempt = 0; attempt < kSplits + kShakes + kCollapses; ++attempt) {
      control_.check();
      copied_ += complex.tet_count();
      if (copied_ > kMostCopied || mends_ > kMostMends) return false;
      if (!disturb(corners, attempt)) continue;
      settle(corners, static_cast<int>(vertices.size()));
      if (is_better_than(complex, vertices)) return true;
      state_.complex = complex;
      state_.vertices = vertices;
    }
    return false;
  }

  bool disturb(const Corners& corners, int attempt) {
    if (attempt < kSplits) return split(corners, attempt);
    if (attempt < kSplits + kShakes) return shake(corners, 0.1 * (1 + attempt - kSplits));
    return collapse(corners, attempt - kSplits - kShakes);
  }

  double length(int a, int b) const { return (state_.position(a) - state_.position(b)).norm(); }

  /// The edge that is so many places after the longest.
  bool split(const Corners& v, int place) {
    std::array<std::array<int, 2>, 6> edges;
    for (int e = 0; e < 6; ++e) edges[e] = {v[kEdgeVertices[e][0]], v[kEdgeVertices[e][1]]};
    std::stable_sort(edges.begin(), edges.end(),
                     [&](const auto& p, const auto& q) { return length(p[0], p[1]) > length(q[0], q[1]); });
    const auto& [a, b] = edges[place];
    return length(a, b) >= 2.0 * state_.min_size && split_edge(state_, a, b, find(v)) >= 0;
  }

  bool shake(const Corners& corners, double part) {
    bool any = false;
    for (int v : corners) {
      const Vertex& vertex = state_.vertices[v];
      if (vertex.frozen || vertex.is_fixed()) continue;
      state_.complex.star(v, star_);
      double shortest = std::numeric_limits<double>::infinity();
      for (int t : star_)
        for (int w : state_.complex.tet(t).vertex)
          if (w != v) shortest = std::min(shortest, length(v, w));
      for (int turn = 0; turn < 3; ++turn) {
        const Vec3 way = part * std::sqrt(shortest * mean_length(corners)) * mender_.random_direction();
        const std::optional<Vertex> moved = state_.moved(vertex, vertex.position + way);
        if (!moved || !stays_positive(state_, v, moved->position, star_) ||
            !may_move(state_, v, *moved, star_))
          continue;
        const double size = vertex.size;
        state_.vertices[v] = *moved;
        state_.vertices[v].size = size;
        any = true;
        break;
      }
    }
    return any;
  }

  double mean_length(const Corners& v) const {
    double sum = 0.0;
    for (const auto& [i, j] : kEdgeVertices) sum += length(v[i], v[j]) / 6.0;
    return sum;
  }

  bool collapse(const Corners& v, int which) {
    constexpr double kLeast = 0.1;
    const int from = which / 3, to = (from + 1 + which % 3) % 4;
    return collapse_edge(state_, v[from], v[to], score_, kLeast, state_.complex.own_site());
  }

  /// Mends around the disturbed tetrahedron and the vertices added since there were `old_vertices`.
  void settle(const Corners& corners, int old_vertices) {
    constexpr int kRounds = 4;
    constexpr std::size_t kMostAtOnce = 40;
    std::vector<int> centre(corners.begin(), corners.end());
    for (int v = old_vertices; v < state_.complex.vertex_slots(); ++v) centre.push_back(v);
    for (int round = 0; round < kRounds; ++round) {
      std::vector<std::pair<double, int>> bad;
      for (int t : around(centre))
        if (const double score = score_(t); score < kSettled) bad.push_back({score, t});
      if (bad.empty()) return;
      std::sort(bad.begin(), bad.end());
      if (bad.size() > kMostAtOnce) bad.resize(kMostAtOnce);
      mends_ += static_cast<int>(bad.size());
      bool any = false;
      for (const auto& [score, t] : bad)
        if (state_.complex.tet(t).alive() && score_(t) < kSettled) any |= mender_.mend(t, round == 1);
      if (!any) return;
    }
  }

  /// The tetrahedra at these vertices and at their neighbours.
  std::vector<int> around(const std::vector<int>& centre) {
    std::vector<int> tets;
    const auto add_star = [&](int v) {
      if (state_.complex.tet_at(v) < 0) return;
      state_.complex.star(v, star_);
      tets.insert(tets.end(), star_.begin(), star_.end());
    };
    const auto unique = [](std::vector<int>& list) {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    };
    for (int v : centre) add_star(v);
    std::vector<int> near;
    for (int t : tets)
      for (int v : state_.complex.tet(t).vertex) near.push_back(v);
    unique(near);
    for (int v : near) add_star(v);
    unique(tets);
    return tets;
  }

  MeshState& state_;
  RunControl& control_;
  const TetScore score_, shape_;
  TetMender mender_;
  std::vector<int> star_;
  std::int64_t copied_ = 0;
  int mends_ = 0;
};

}  // namespace

int raise_worst_angles(MeshState& state, const QualityGoal& goal, RunControl& control) {
  return Rescue(state, goal, control).run();
}

}  // namespace fgmesh
