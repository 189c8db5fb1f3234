// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/distance_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brep/occt.hpp"
#include "brep/recent_distances.hpp"
#include "brep/tet_distances.hpp"

namespace fgmesh::brep {
namespace {

// Parts of the shape's size. Nearer to a face than this the direction to its nearest point is mostly rounding
// error, and its normal tells more;
constexpr double kClose = 1e-6;
// nearer than this a point is on the face.
constexpr double kOn = 1e-12;
// nearer than this to a corner the nearest point is the corner.
constexpr double kCorner = 1e-9;

// Distances that differ by less, as a part of them, are one and the same found twice.
constexpr double kSame = 1e-9;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// The sum of the normals of the triangles around each sample, weighted by their angles: where the sample is
/// the nearest point, it tells the side (Baerentzen and Aanaes, Signed distance computation using the angle
/// weighted pseudonormal).
std::vector<Vec3> angle_weighted_normals(const SampledBoundary& boundary, int solid) {
  std::vector<Vec3> normals(boundary.points.size(), Vec3::Zero());
  for (std::size_t i = 0; i < boundary.triangles.size(); ++i) {
    const bool behind = boundary.triangle_solids[i][0] == solid;
    if (!behind && boundary.triangle_solids[i][1] != solid) continue;
    const std::array<int, 3>& corners = boundary.triangles[i];
    for (int k = 0; k < 3; ++k) {
      const Vec3& here = boundary.points[corners[k]];
      const Vec3 next = boundary.points[corners[(k + 1) % 3]] - here;
      const Vec3 last = boundary.points[corners[(k + 2) % 3]] - here;
      const Vec3 across = next.cross(last);
      const double angle = std::atan2(across.norm(), next.dot(last));
      normals[corners[k]] += (behind ? angle : -angle) * across.normalized();
    }
  }
  return normals;
}

}  // namespace

struct DistanceField::Found {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< of the face, out of its first solid
  int face = 0, edge = 0;      ///< where it is; both 0: at a point
  bool on_border = false;      ///< of `face`: the search ended at the surface's bounds

  /// A face's normal tells no side on its border, where it is up to the edge.
  void take_on_face(const Vec3& p, const SurfacePoint& at, int number) {
    const Vec3 away = p - at.position;
    const double there = away.norm();
    const bool border = away.cross(at.normal).norm() > 1e-6 * there;
    if (there < (border ? (1.0 - kSame) * distance : distance)) {
      *this = {there, at.position, at.normal, number, 0, border};
    }
  }

  void take(const Vec3& p, const Vec3& at, int on_edge) {
    const double there = (at - p).norm();
    if (there < (on_border ? (1.0 + kSame) * distance : distance)) {
      *this = {there, at, Vec3::Zero(), 0, on_edge, false};
    }
  }
};

/// Memory of one call, and what was done for the point in work.
struct DistanceField::Scratch {
  struct Minimum {
    int face;
    Vec3 position;
  };

  std::vector<PieceTree::Candidate> candidates;
  std::vector<Minimum> minima;
  std::vector<int> faces_done, edges_done;  ///< the last point for which the closed form of each was asked
  int point = 0;
};

DistanceField::DistanceField(std::shared_ptr<const MeasuredShape> measured, std::vector<Piece> pieces,
                             int solid)
    : measured_(std::move(measured)),
      tree_(std::move(pieces)),
      solid_(solid),
      id_(next_field_id()),
      size_(measured_->shape.bounds.diagonal()) {
  if (solid_ == 0) return;
  samples_ = NearestPoint(measured_->sampling.boundary.points);
  sample_normals_ = angle_weighted_normals(measured_->sampling.boundary, solid_);
}

void DistanceField::look_at_face(const Vec3& p, const PieceTree::Candidate& candidate, Found& found,
                                 Scratch& scratch) const {
  const Piece& piece = tree_.piece(candidate.piece);
  const FaceProjector& projector = *measured_->projections.faces[piece.face - 1];
  if (projector.has_closed_form()) {
    int& done = scratch.faces_done[piece.face - 1];
    if (done == scratch.point) return;
    done = scratch.point;
  } else {
    // About the nearest point of a surface that bends less than the ball through it there is no other.
    const double reach = 0.5 * found.distance + 2.0 * piece.thickness;
    const auto& [a, b, c] = piece.corners;
    const bool outside = (b - a).cross(c - a).dot(p - a) > 0.0;
    const bool known =
        found.distance * piece.curvatures[outside ? 0 : 1] < 0.5 &&
        std::any_of(scratch.minima.begin(), scratch.minima.end(), [&](const Scratch::Minimum& minimum) {
          return minimum.face == piece.face && (minimum.position - candidate.nearest).norm() < reach;
        });
    if (known) return;
  }
  bool covered = false;
  const SurfacePoint at = projector.project_to_surface(p, candidate.nearest, covered);
  if (!projector.has_closed_form()) scratch.minima.push_back({piece.face, at.position});
  if (covered) found.take_on_face(p, at, piece.face);
}

void DistanceField::look_at_edge(const Vec3& p, const Piece& piece, Found& found, Scratch& scratch) const {
  const EdgeProjector& projector = *measured_->projections.edges[piece.edge - 1];
  if (projector.has_closed_form()) {
    int& done = scratch.edges_done[piece.edge - 1];
    if (done == scratch.point) return;
    done = scratch.point;
    found.take(p, projector.project(p).position, piece.edge);
    return;
  }
  // From both ends, since where the curve bends about the point there may be two minima.
  for (const double start : {piece.low, piece.high}) {
    const CurvePoint at = projector.project_between(p, piece.low, piece.high, start);
    found.take(p, at.position, piece.edge);
  }
}

DistanceField::Found DistanceField::nearest(const Vec3& p, Scratch& scratch) const {
  ++scratch.point;
  scratch.minima.clear();
  tree_.find(p, scratch.candidates);
  Found found;
  for (const PieceTree::Candidate& candidate : scratch.candidates) {
    if (candidate.at_least > found.distance) break;
    const Piece& piece = tree_.piece(candidate.piece);
    if (piece.face > 0) {
      look_at_face(p, candidate, found, scratch);
    } else if (piece.edge > 0) {
      look_at_edge(p, piece, found, scratch);
    } else {
      found.take(p, candidate.nearest, 0);
    }
  }
  return found;
}

/// The face's outward normal, seen from the solid that distances are measured to.
Vec3 DistanceField::face_normal(int face, const Vec3& normal) const {
  const bool before = solid_ > 0 && measured_->shape.topology.face_use(face).solid_behind != solid_;
  return before ? Vec3(-normal) : normal;
}

/// A vector that makes less than a right angle with every way out of the solid that has its nearest point
/// here.
Vec3 DistanceField::outward(const Found& found) const {
  if (found.face > 0 && !found.normal.isZero()) return face_normal(found.face, found.normal);
  const int sample = samples_(found.position);
  const Vec3 gap = measured_->sampling.boundary.points[sample] - found.position;
  if (found.edge == 0 || gap.norm() < kCorner * size_) return sample_normals_[sample];
  Vec3 sum = Vec3::Zero();
  const Topology& topology = measured_->shape.topology;
  for (const int face : topology.edge_use(found.edge).faces) {
    const FaceUse& use = topology.face_use(face);
    if (use.solid_behind != solid_ && use.solid_before != solid_) continue;
    sum += face_normal(face, measured_->projections.faces[face - 1]->project(found.position).normal);
  }
  return sum;
}

double DistanceField::measure(const Vec3& p, Scratch& scratch, Vec3* gradient) const {
  const Found found = nearest(p, scratch);
  if (!std::isfinite(found.distance)) {
    if (gradient) gradient->setConstant(kNaN);
    return kNaN;
  }
  const Vec3 away = p - found.position;
  if (solid_ == 0 && !gradient) return found.distance;
  const Vec3 normal = solid_ > 0 ? outward(found) : found.normal;
  const double side = away.dot(normal);
  const double sign = solid_ > 0 && side < 0.0 ? -1.0 : 1.0;
  if (!gradient) return sign * found.distance;

  if (found.distance > kClose * size_ || (normal.isZero() && found.distance > 0.0)) {
    *gradient = sign / found.distance * away;
  } else if (solid_ > 0) {
    *gradient = normal.normalized();
  } else {
    *gradient = side > kOn * size_ ? normal : Vec3(-normal);
  }
  return sign * found.distance;
}

void DistanceField::evaluate(const Vec3* points, std::size_t count, double* values) const {
  evaluate(points, count, values, nullptr);
}

void DistanceField::evaluate(const Vec3* points, std::size_t count, double* values, Vec3* gradients) const {
  Scratch scratch;
  scratch.faces_done.assign(measured_->projections.faces.size(), 0);
  scratch.edges_done.assign(measured_->projections.edges.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    Vec3* const gradient = gradients ? gradients + i : nullptr;
    try {
      values[i] = measure(points[i], scratch, gradient);
    } catch (const Standard_Failure&) {
      values[i] = kNaN;
      if (gradient) gradient->setConstant(kNaN);
    }
  }
}

void DistanceField::bounds(const Box& box, double& low, double& high) const {
  // A distance changes by no more than the way that one goes.
  const Vec3 centre = 0.5 * (box.low + box.high);
  const double radius = 0.5 * box.diagonal();
  const double margin = (radius + 1e-9 * (size_ + centre.norm())) * (1.0 + 1e-12);
  double distance = kNaN;
  if (std::isfinite(margin)) evaluate(&centre, 1, &distance);
  if (std::isnan(distance)) {
    low = -std::numeric_limits<double>::infinity();
    high = std::numeric_limits<double>::infinity();
  } else {
    low = distance - margin;
    high = distance + margin;
  }
  if (solid_ == 0) low = std::max(low, 0.0);
}

void DistanceField::tet_bounds(const Corners& tet, double& low, double& high) const {
  CornerDistances corners;
  for (int i = 0; i < 4; ++i) {
    corners.values[i] = recent(id_, tet[i], corners.gradients[i], [&](Vec3& gradient) {
      double value = kNaN;
      evaluate(&tet[i], 1, &value, &gradient);
      return value;
    });
    if (!std::isfinite(corners.values[i])) return bounds(box_around(tet), low, high);
  }
  const double margin = 1e-9 * (size_ + tet[0].norm());
  const DistanceBounds found = bounds_between(tet, corners, kClose * size_, solid_ > 0, margin);
  low = found.low;
  high = found.high;
}

}  // namespace fgmesh::brep
