// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/boundary_sizes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/meshing_start.hpp"
#include "pipeline/volumes.hpp"
#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

constexpr double kGrowth = 0.6;  // of sizes inwards, mm a mm, as both stages have it

/// How the lesser principal curvature of a face counts beside the greater: 1 by the centres of triangles, 0
/// by their edges.
constexpr double kAcross = 0.5;

/// Curvature, 1/mm, of a face on which a triangle has its corners, from how far the middles of its edges are
/// off. Slender triangles tell little across their length.
double curvature_of(const std::array<Vec3, 3>& corner, const std::array<double, 3>& errors) {
  const Vec3 x = (corner[1] - corner[0]).normalized();
  const Vec3 normal = area_vector(corner[0], corner[1], corner[2]);
  if (normal.isZero()) return 0.0;
  const Vec3 y = normal.cross(x).normalized();
  Eigen::Matrix3d rows;
  Vec3 bends;  // curvature times squared length
  double largest = 0.0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 way = corner[(k + 1) % 3] - corner[k];
    const double u = way.dot(x), v = way.dot(y);
    rows.row(k) << u * u, 2.0 * u * v, v * v;
    bends[k] = 8.0 * errors[k];
    largest = std::max(largest, bends[k] / way.squaredNorm());
  }
  const Vec3 form = rows.partialPivLu().solve(bends);
  const double sum = std::abs(form[0] + form[2]), difference = std::hypot(form[0] - form[2], 2.0 * form[1]);
  const double greater = 0.5 * (sum + difference), lesser = 0.5 * std::abs(sum - difference);
  const double bend = greater + kAcross * lesser;
  return std::isfinite(bend) ? std::clamp(bend, largest, (1.0 + kAcross) * largest) : largest;
}

}  // namespace

BentBoundary::BentBoundary(const MeshState& state, const BrepModel& model, RunControl& control)
    : state_(state), model_(model) {
  for (int t = 0; t < state.complex.slots(); ++t) {
    if (t % 256 == 0) control.check();
    const Tet& tet = state.complex.tet(t);
    for (int face = 0; face < 4 && tet.alive(); ++face)
      if (tet.label[face]) parts_.push_back(facet(tet, face));
  }
  for (const auto& [a, b, edge] : state.complex.creases()) {
    Part part;
    part.corner = {state.position(a), state.position(b), state.position(b)};
    part.beyond = crease_error(state, state.vertices[a], state.vertices[b], edge);
    part.curvature = 8.0 * part.beyond / (part.corner[1] - part.corner[0]).squaredNorm();
    parts_.push_back(part);
  }
}

BentBoundary::Part BentBoundary::facet(const Tet& tet, int face) const {
  const auto vertex = [&](int k) -> const Vertex& {
    return state_.vertices[tet.vertex[kFaceVertices[face][k % 3]]];
  };
  Part part;
  part.solid = tet.solid;
  std::array<double, 3> errors;
  const double* guess = nullptr;
  for (int k = 0; k < 3; ++k) {
    part.corner[k] = vertex(k).position;
    if (vertex(k).carrier.dimension == 2) guess = vertex(k).parameter.data();
    errors[k] = chord_error(state_, vertex(k), vertex(k + 1), tet.label[face]);
  }
  const Vec3 normal = 0.5 * area_vector(part.corner[0], part.corner[1], part.corner[2]);
  const Vec3 centre = (part.corner[0] + part.corner[1] + part.corner[2]) / 3.0;
  const Vec3 way = state_.boundary().project_to_face(tet.label[face], centre, guess).position - centre;
  part.area = normal.norm();
  part.beyond = std::copysign(way.norm(), way.dot(normal));
  part.curvature = curvature_of(part.corner, errors);
  return part;
}

/// The centre of a regular triangle of the edge L on a cylinder is off by L^2 / 12 times the curvature, the
/// middle of an edge by L^2 / 8 times its own. `turn`: radians, by which the normal may turn over an edge.
GradedSizes BentBoundary::sizes(double deviation, double least, double turn) const {
  constexpr double kSlight = 0.25;  // of the deviation: such parts are far from being split
  std::vector<SizeSource> sources;
  for (const Part& part : parts_) {
    if (std::abs(part.beyond) < kSlight * deviation || !(part.curvature > 0.0)) continue;
    const double wanted = std::sqrt((part.solid ? 12.0 : 10.0) * deviation / part.curvature);
    sources.push_back({part.corner, std::max(least, std::min(wanted, turn / part.curvature))});
  }
  return GradedSizes(std::move(sources), kGrowth);
}

GradedSizes BentBoundary::initial_sizes(double size, double min_size) const {
  return sizes(initial_deviation(size), min_size, 1.0);
}

GradedSizes BentBoundary::deviation_sizes(double deviation, double min_size) const {
  return sizes(deviation, std::max(2.0 * deviation, min_size), std::numeric_limits<double>::infinity());
}

double BentBoundary::lowered(double deviation) const {
  constexpr double kMean = 0.5;  // of facets' deviations, as part of the largest that is allowed
  while (deviation > least_deviation(state_.diagonal())) {
    std::vector<double> lost(model_.solid_count(), 0.0);
    for (const Part& part : parts_)
      if (part.solid)
        lost[part.solid - 1] +=
            0.75 * part.area * std::clamp(part.beyond, -kMean * deviation, kMean * deviation);
    double error = 0.0;
    for (std::size_t i = 0; i < lost.size(); ++i)
      error = std::max(error, std::abs(lost[i]) / model_.volumes()[i]);
    if (error <= kVolumeGoal) break;
    deviation = lowered_deviation(deviation, error, state_.diagonal());
  }
  return deviation;
}

}  // namespace fgmesh
