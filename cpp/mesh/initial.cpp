// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/initial.hpp"

#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>

#include <sstream>

#include "core/error.hpp"
#include "mesh/boundary_recovery.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/small_features.hpp"
#include "mesh/surface_remeshing.hpp"
#include "mesh/swap_pass.hpp"
#include "mesh/worst_first.hpp"

namespace fgmesh {
namespace {

/// CGAL would print to standard error what its exception says as well.
void ignore_failure(const char*, const char*, const char*, int, const char*) {}

/// Takes away the flat tetrahedra that a Delaunay triangulation leaves between vertices of one plane.
void untangle(MeshState& state, RunControl& control) {
  const TetScore score(state, {10.0, 170.0, false});
  WorstFirst mender(state, score);
  mender.run(3, control);
  mender.allow_insertion();
  mender.run(6, control);
  const std::vector<int> left = mender.bad_tets(0.0);
  if (left.empty()) return;
  Vec3 centre = Vec3::Zero();
  for (int v : state.complex.tet(left.front()).vertex) centre += 0.25 * state.position(v);
  std::ostringstream text;
  text << "the initial mesh folds over at " << left.size() << " tetrahedra, the first at " << Shown{centre}
       << " mm: the elements are too coarse for the shape there; lower MaxSize";
  throw GeometryError(text.str());
}

constexpr double kGrowth = 0.6;  // of sizes, mm a mm

/// Whether the middle of an inner edge lies close above a facet of the boundary at the edge's end. A vertex
/// there makes flat tetrahedra, whose long edges would be split next.
bool hugs_boundary(const MeshState& state, int a, int b, const EdgeRing& ring) {
  constexpr double kClose = 0.15;  // of the edge's length
  const Vec3 middle = 0.5 * (state.position(a) + state.position(b));
  const double least = kClose * (state.position(a) - state.position(b)).norm();
  for (int t : ring.tet) {
    const Tet& tet = state.complex.tet(t);
    for (int face = 0; face < 4; ++face) {
      if (!tet.label[face]) continue;
      const int* k = kFaceVertices[face];
      const Vec3& corner = state.position(tet.vertex[k[0]]);
      const Vec3 normal =
          area_vector(corner, state.position(tet.vertex[k[1]]), state.position(tet.vertex[k[2]]))
              .normalized();
      if (std::abs(normal.dot(middle - corner)) < least) return true;
    }
  }
  return false;
}

/// Splits inner edges that are longer than the size grown inwards from the boundary.
void fill_inside(MeshState& state, const InitialMeshOptions& options, RunControl& control) {
  constexpr double kTooLong = 1.5;
  constexpr int kMostRounds = 12, kMostPasses = 6;
  constexpr double kFewSwaps = 0.02, kFewSplits = 0.005;  // of the tetrahedra
  TetComplex& complex = state.complex;
  const OdtEnergy energy(state);
  for (int round = 0; round < kMostRounds; ++round) {
    for (int pass = 0; pass < kMostPasses; ++pass)
      if (swap_pass(state, energy, control) <= kFewSwaps * complex.tet_count()) break;
    for (Vertex& vertex : state.vertices)
      if (vertex.carrier.dimension == 3) vertex.size = options.size;
    limit_growth(state, kGrowth);
    const int old_vertices = complex.vertex_slots();
    int count = 0;
    for (int t = 0; t < complex.slots(); ++t) {
      if (!complex.tet(t).alive()) continue;
      const std::array<int, 4> v = complex.tet(t).vertex;
      if (*std::max_element(v.begin(), v.end()) >= old_vertices) continue;
      double largest = kTooLong;
      std::array<int, 2> edge = {-1, -1};
      EdgeRing ring;
      for (const auto& [i, j] : kEdgeVertices) {
        const double length = (state.position(v[i]) - state.position(v[j])).norm();
        const double ratio =
            length / std::min(options.size, 0.5 * (state.vertices[v[i]].size + state.vertices[v[j]].size) +
                                                0.25 * kGrowth * length);
        if (ratio <= largest) continue;
        complex.ring(v[i], v[j], t, ring);
        if (state.label_at(v[i], v[j], ring) || hugs_boundary(state, v[i], v[j], ring)) continue;
        largest = ratio;
        edge = {v[i], v[j]};
      }
      if (t % 256 == 0) control.check_at(state.position(v[0]));
      if (edge[0] >= 0 && split_edge(state, edge[0], edge[1], t) >= 0) ++count;
    }
    if (count <= kFewSplits * complex.tet_count()) return;
  }
}

std::vector<Carrier> mesh_once(MeshState& state, const SampledBoundary& samples, const WallThickness& walls,
                               const InitialMeshOptions& options, RunControl& control) {
  std::vector<Carrier> bridged;
  try {
    SurfaceMesh surface(state, samples);
    bridged = bridge_small_features(surface, options.bridged, control);
    remesh_surface(surface, walls, {options.size, options.deviation, kGrowth, options.min_size}, control);
    tetrahedralize(state, surface, control);
  } catch (const CGAL::Failure_exception& error) {
    throw GeometryError(std::string("CGAL could not triangulate the solid: ") + error.what());
  }
  for (Vertex& vertex : state.vertices) state.evaluate(vertex);
  fill_inside(state, options, control);
  untangle(state, control);
  return bridged;
}

}  // namespace

std::vector<Carrier> make_initial_mesh(MeshState& state, const SampledBoundary& samples,
                                       const InitialMeshOptions& options, RunControl& control) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);  // a failed assertion would end the process otherwise
  CGAL::set_error_handler(ignore_failure);
  // A mesh too coarse for a detail of the shape loses or folds it; a finer one may not.
  constexpr int kAttempts = 3;
  const WallThickness walls(samples);
  InitialMeshOptions attempt = options;
  for (int left = kAttempts;; --left) {
    control.check();
    try {
      return mesh_once(state, samples, walls, attempt, control);
    } catch (const GeometryError&) {
      if (left == 1) throw;
    }
    attempt.size *= 0.5;
    attempt.deviation *= 0.4;
  }
}

}  // namespace fgmesh
