// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/geometry_refinement.hpp"

#include "mesh/edge_split.hpp"
#include "mesh/laplacian_smoothing.hpp"
#include "mesh/steiner_points.hpp"
#include "mesh/swap_pass.hpp"
#include "mesh/worst_angles.hpp"
#include "mesh/worst_first.hpp"

namespace fgmesh {
namespace {

double length(const MeshState& state, int a, int b) { return (state.position(a) - state.position(b)).norm(); }

/// The edge of a boundary facet to split so that it comes closer to its face: the one with the largest chord
/// error, the longest where all are alike.
std::array<int, 2> edge_to_split(const MeshState& state, const std::array<int, 3>& facet, int label) {
  std::array<int, 2> best = {facet[0], facet[1]};
  double largest = -1.0;
  for (int i = 0; i < 3; ++i) {
    const int a = facet[i], b = facet[(i + 1) % 3];
    const double size = length(state, a, b);
    const double rank = size + 8.0 * chord_error(state, state.vertices[a], state.vertices[b], label);
    if (rank > largest) {
      largest = rank;
      best = {a, b};
    }
  }
  return best;
}

/// Splits facets and crease edges that are too far off; no facet touched by a new vertex of this round is
/// split again. Returns how many.
int split_boundary(MeshState& state, const GeometryRefinementOptions& options, RunControl& control) {
  TetComplex& complex = state.complex;
  const int old_vertices = complex.vertex_slots();
  int count = 0;
  for (const auto& [a, b, edge] : complex.creases()) {
    if (length(state, a, b) < 2.0 * state.min_size ||
        crease_error(state, state.vertices[a], state.vertices[b], edge) <= options.deviation)
      continue;
    const int t = complex.find_edge(a, b);
    if (t >= 0 && split_edge(state, a, b, t) >= 0) ++count;
  }
  for (int t = 0; t < complex.slots(); ++t) {
    if (t % 256 == 0) control.check();
    for (int face = 0; face < 4 && complex.tet(t).alive(); ++face) {
      const Tet& tet = complex.tet(t);
      if (!tet.label[face]) continue;
      const std::array<int, 3> facet = {tet.vertex[kFaceVertices[face][0]],
                                        tet.vertex[kFaceVertices[face][1]],
                                        tet.vertex[kFaceVertices[face][2]]};
      if (*std::max_element(facet.begin(), facet.end()) >= old_vertices) continue;
      if (facet_deviation(state, t, face) <= options.deviation) continue;
      const auto [a, b] = edge_to_split(state, facet, tet.label[face]);
      if (length(state, a, b) >= 2.0 * state.min_size && split_boundary_edge(state, a, b, t) >= 0) ++count;
    }
  }
  return count;
}

/// Sizes that the deviation asks for: where a boundary edge of length L has chord error c, the true face's
/// curvature wants edges of L sqrt(deviation / c), whatever the mesh there looks like now. They may grow
/// inwards at a bounded rate.
void grade_sizes(MeshState& state, const GeometryRefinementOptions& options) {
  const TetComplex& complex = state.complex;
  for (Vertex& vertex : state.vertices) vertex.size = state.diagonal();
  for (int t = 0; t < complex.slots(); ++t) {
    const Tet& tet = complex.tet(t);
    if (!tet.alive()) continue;
    for (int e = 0; e < 6; ++e) {
      const int first = tet.label[kEdgeVertices[5 - e][0]], second = tet.label[kEdgeVertices[5 - e][1]];
      if (!first && !second) continue;
      Vertex &a = state.vertices[tet.vertex[kEdgeVertices[e][0]]],
             &b = state.vertices[tet.vertex[kEdgeVertices[e][1]]];
      const double error = chord_error(state, a, b, first ? first : second);
      const double size = (a.position - b.position).norm();
      if (!(error > 1e-6 * options.deviation)) continue;
      const double wanted = std::max(2.0 * options.deviation, size * std::sqrt(options.deviation / error));
      a.size = std::min(a.size, wanted);
      b.size = std::min(b.size, wanted);
    }
  }
  limit_growth(state, options.growth);
}

/// Splits edges that are much longer than the graded size wants. Returns how many.
int split_to_size(MeshState& state, RunControl& control) {
  constexpr double kTooLong = 1.7;
  const auto excess = [&](int a, int b, double length) {
    return 2.0 * length / (kTooLong * (state.vertices[a].size + state.vertices[b].size));
  };
  return split_long_edges(state, excess, control);
}

/// Delaunay refinement of what is too far from the true boundary, graded inwards, and smoothing of the new
/// vertices.
void approach_boundary(MeshState& state, const GeometryRefinementOptions& options, RunControl& control) {
  const TetScore shape(state, {options.goal.smallest_angle, options.goal.largest_angle, false});
  const OdtEnergy energy(state, state.threshold());
  constexpr int kMostRounds = 60, kRoundsInside = 3;
  for (int round = 0, quiet = 0; round < kMostRounds && quiet < kRoundsInside; ++round) {
    control.report(0.7 * round / (round + 4.0), state.complex.tet_count());
    const int on_boundary = split_boundary(state, options, control);
    grade_sizes(state, options);
    const int inside = split_to_size(state, control);
    if (on_boundary + inside == 0) return;
    quiet = on_boundary > 0 ? 0 : quiet + 1;
    swap_pass(state, energy, control);
    for (int sweep = 0; sweep < 2; ++sweep) laplacian_sweep(state, shape, 0.3, control);
  }
}

/// Keeps the vertices that there are in place for its lifetime.
class Freeze {
 public:
  explicit Freeze(MeshState& state) : state_(state) {
    for (Vertex& vertex : state.vertices) was_frozen_.push_back(std::exchange(vertex.frozen, true));
  }
  ~Freeze() {
    for (std::size_t v = 0; v < was_frozen_.size(); ++v) state_.vertices[v].frozen = was_frozen_[v];
  }
  Freeze(const Freeze&) = delete;
  Freeze& operator=(const Freeze&) = delete;

 private:
  MeshState& state_;
  std::vector<bool> was_frozen_;
};

/// Brings threshold and angles in order, and again where that has moved the boundary away from the true one.
void mend(MeshState& state, const GeometryRefinementOptions& options, RunControl& control) {
  const TetScore score(state, options.goal);
  WorstFirst mender(state, score);
  constexpr int kMostRepairs = 12;
  for (int repair = 0; repair < kMostRepairs; ++repair) {
    if (repair == 1) mender.allow_insertion();
    control.report(0.7 + 0.3 * repair / kMostRepairs, state.complex.tet_count());
    const int left = mender.run(6, control);
    const int above = count_above(state, state.threshold());
    int changed = split_boundary(state, options, control);
    if (above > 0)
      changed += insert_steiner_points(state, state.threshold(), std::max(8, above / 4), control);
    changed += split_long_edges(state, options.goal.longest_edge, control);
    if (changed == 0 && (left == 0 || repair > 3)) return;
  }
  mender.run(10, control);
}

}  // namespace

double facet_deviation(const MeshState& state, int t, int face) {
  const Tet& tet = state.complex.tet(t);
  Vec3 centre = Vec3::Zero();
  const double* guess = nullptr;
  for (int k = 0; k < 3; ++k) {
    const Vertex& vertex = state.vertices[tet.vertex[kFaceVertices[face][k]]];
    centre += vertex.position / 3.0;
    if (vertex.carrier.dimension == 2) guess = vertex.parameter.data();
  }
  return (state.boundary().project_to_face(tet.label[face], centre, guess).position - centre).norm();
}

void refine_geometry(MeshState& state, const GeometryRefinementOptions& options, RunControl& control) {
  state.chord_limit =
      0.7 * options.deviation;  // the centre of a facet is farther off than the middles of its edges
  // What comes new is as small as the deviation wants it in all directions; stretched swaps there would only
  // make more splits necessary. The material's stretched elements stay by their frozen vertices.
  for (Vertex& vertex : state.vertices) vertex.stretch = Vec3::Zero();
  {
    const Freeze freeze(state);
    approach_boundary(state, options, control);
  }

  mend(state, options, control);
  constexpr int kMostPasses = 3;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    if (raise_worst_angles(state, options.goal, control) == 0 || split_boundary(state, options, control) == 0)
      return;
    mend(state, options, control);
  }
}

}  // namespace fgmesh
