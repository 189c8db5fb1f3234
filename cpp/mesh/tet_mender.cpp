// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_mender.hpp"

#include <algorithm>

#include "mesh/edge_collapse.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/odt_smoothing.hpp"

namespace fgmesh {
namespace {

/// A change of the connectivity is worth it where the worst score around it rises by this.
constexpr double kClearly = 0.01;

/// A vertex of more tetrahedra is not drawn onto another: that takes long, and hardly ever makes them better.
constexpr std::size_t kLargestStar = 256;

/// Moves the value by `step`, to first order.
void foretell(MaterialValue& value, const Vec3& step) {
  for (std::size_t i = 0; i < value.composition.size(); ++i)
    value.composition[i] += value.gradient[i].dot(step);
}

}  // namespace

Vec3 TetMender::random_direction() {
  // Numerical Recipes' linear congruence: the same on every machine, unlike the library's distributions.
  const auto next = [&] {
    random_ = 1664525u * random_ + 1013904223u;
    return static_cast<double>(random_ >> 8) / 8388608.0 - 1.0;
  };
  Vec3 direction;
  do {
    direction = Vec3(next(), next(), next());
  } while (direction.squaredNorm() > 1.0 || direction.squaredNorm() < 0.01);
  return direction.normalized();
}

double TetMender::star_score(int v, const Vertex& moved, double stop_below) const {
  double worst = 1.0;
  for (int t : star_) {
    worst = std::min(worst, score_.with(t, v, moved));
    if (worst <= stop_below) break;
  }
  return worst;
}

/// Whether the worst score around a boundary vertex would rise if its face or edge were flat: the true one is
/// slow to ask.
bool TetMender::is_promising(int v, const Vec3& way, double best) const {
  Vertex moved = state_.vertices[v];
  const Vec3& direction = moved.direction;
  if (moved.carrier.dimension == 3 || direction.isZero()) return true;
  const Vec3 along = direction.dot(way) * direction;
  const Vec3 step = moved.carrier.dimension == 1 ? along : Vec3(way - along);
  moved.position += step;
  foretell(moved.own, step);
  for (MaterialValue& other : moved.others) foretell(other, step);
  return star_score(v, moved, best) > best;
}

bool TetMender::improve_vertex(int v) {
  if (state_.vertices[v].frozen || state_.vertices[v].is_fixed()) return false;
  state_.complex.star(v, star_);
  double length = 0.0;
  int edges = 0;
  std::vector<std::pair<double, int>> scores;
  scores.reserve(star_.size());
  for (int t : star_) {
    scores.emplace_back(score_(t), t);
    for (int w : state_.complex.tet(t).vertex) {
      length += (state_.position(w) - state_.position(v)).norm();
      edges += w != v;
    }
  }
  std::stable_sort(scores.begin(), scores.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  double best = scores.front().first;
  if (best >= 1.0) return false;
  length /= edges;

  const Tet& worst = state_.complex.tet(scores.front().second);
  const int* base = kFaceVertices[worst.index_of(v)];
  const Vec3 away =
      -area_vector(state_.position(worst.vertex[base[0]]), state_.position(worst.vertex[base[1]]),
                   state_.position(worst.vertex[base[2]]))
           .normalized();
  const Vec3 gradient = steepest(state_.vertices[v].own.gradient).normalized();
  const Vec3 centre = odt_target(state_, v, star_) - state_.position(v);
  // The worst first: these tell of most moves that they are none, and the others need not be asked.
  std::transform(scores.begin(), scores.end(), star_.begin(), [](const auto& entry) { return entry.second; });

  bool improved = false;
  for (double step = 0.3 * length; step > 0.02 * length; step *= 0.5) {
    const std::array<Vec3, 7> ways = {away * step,
                                      gradient * step,
                                      gradient * -step,
                                      centre * (step / length),
                                      random_direction() * step,
                                      random_direction() * step,
                                      random_direction() * step};
    for (const Vec3& way : ways) {
      if (!way.allFinite() || !is_promising(v, way, best)) continue;
      const std::optional<Vertex> moved = state_.moved(state_.vertices[v], state_.position(v) + way);
      if (!moved) continue;
      // The true surface is slow to ask.
      const double score = star_score(v, *moved, best);
      if (score <= best + 1e-6 * std::abs(best) || !may_move(state_, v, *moved, star_)) continue;
      const double size = state_.vertices[v].size;
      state_.vertices[v] = *moved;
      state_.vertices[v].size = size;
      best = score;
      improved = true;
    }
    if (best >= 1.0) break;
  }
  return improved;
}

bool TetMender::collapse(int t) {
  const std::array<int, 4> vertices = state_.complex.tet(t).vertex;
  for (int v : vertices) {
    state_.complex.star(v, star_);
    if (star_.size() > kLargestStar) continue;
    double least = 1.0;
    for (int at : star_) least = std::min(least, score_(at));
    for (int w : vertices)
      if (w != v && collapse_edge(state_, v, w, score_, least + kClearly, site_)) return true;
  }
  return false;
}

bool TetMender::insert_vertex(int t) {
  // Best inside, between two boundary vertices: that frees a tetrahedron squeezed flat against the boundary.
  const Tet tet = state_.complex.tet(t);
  Vec3 inward = Vec3::Zero();
  for (int i = 0; i < 4; ++i)
    if (tet.label[i])
      inward -= area_vector(state_.position(tet.vertex[kFaceVertices[i][0]]),
                            state_.position(tet.vertex[kFaceVertices[i][1]]),
                            state_.position(tet.vertex[kFaceVertices[i][2]]))
                    .normalized();
  for (const auto& [i, j] : kEdgeVertices) {
    const int a = tet.vertex[i], b = tet.vertex[j];
    const Vec3 middle = 0.5 * (state_.position(a) + state_.position(b));
    const double length = (state_.position(a) - state_.position(b)).norm();
    for (double step : {0.3, 0.15, 0.6}) {
      const std::array<Vec3, 3> ways = {inward, random_direction(), random_direction()};
      for (const Vec3& way : ways)
        if (insert_beside_edge(state_, a, b, middle + step * length * way, score_, kClearly)) return true;
    }
  }
  return false;
}

bool TetMender::mend(int t, bool may_insert) {
  if (swapper_.improve(t)) return true;
  const double before = score_(t);
  bool any = false;
  const std::array<int, 4> vertices = state_.complex.tet(t).vertex;
  for (int v : vertices) {
    any |= improve_vertex(v);
    if (score_(t) >= 1.0) return true;
  }
  // Moves that gain next to nothing would keep the new vertex away for ever.
  if (any && score_(t) > before + kClearly) return true;
  if (collapse(t)) return true;
  return (may_insert && insert_vertex(t)) || any;
}

}  // namespace fgmesh
