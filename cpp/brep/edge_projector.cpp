// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/edge_projector.hpp"

#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <GeomAdaptor_Curve.hxx>
#include <TopExp.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brep/occt.hpp"
#include "brep/smoothness.hpp"

namespace fgmesh::brep {

EdgeProjector::EdgeProjector(const TopoDS_Edge& edge, std::vector<double> parameters)
    : curve_(BRep_Tool::Curve(edge, first_, last_)), parameters_(std::move(parameters)) {
  TopoDS_Vertex start, end;
  TopExp::Vertices(edge, start, end);
  closed_ = start.IsSame(end) && tangents_agree(*curve_, first_, last_);
  const GeomAdaptor_Curve adaptor(curve_);
  if (adaptor.GetType() == GeomAbs_Line) closed_form_ = adaptor.Line();
  if (adaptor.GetType() == GeomAbs_Circle) closed_form_ = adaptor.Circle();
  std::vector<Vec3> points;
  for (const double t : parameters_) points.push_back(to_vec3(curve_->Value(t)));
  for (std::size_t i = 1; i < points.size(); ++i) length_ += (points[i] - points[i - 1]).norm();
  if (closed_form_.index() != 0) return;
  std::vector<Piece> segments;
  for (std::size_t i = 1; i < points.size(); ++i) {
    Piece& segment = segments.emplace_back();
    segment.corners = {points[i - 1], points[i], points[i]};
    segment.low = parameters_[i - 1];
    segment.high = parameters_[i];
    segment.number = static_cast<int>(i) - 1;
  }
  segments_.emplace(std::move(segments));
}

CurvePoint EdgeProjector::at(double t) const {
  gp_Pnt position;
  gp_Vec derivative;
  curve_->D1(t, position, derivative);
  const double speed = derivative.Magnitude();
  return {to_vec3(position), speed > 0.0 ? Vec3(to_vec3(derivative) / speed) : Vec3::Zero().eval(), t};
}

double EdgeProjector::within_range(double t) const {
  if (t >= first_ && t <= last_) return t;
  if (!closed_) return std::clamp(t, first_, last_);
  return ElCLib::InPeriod(t, first_, last_);
}

CurvePoint EdgeProjector::project(const Vec3& p, const double* guess_t) const {
  if (const gp_Lin* line = std::get_if<gp_Lin>(&closed_form_)) {
    return at(within_range(ElCLib::Parameter(*line, to_gp(p))));
  }
  if (const gp_Circ* circle = std::get_if<gp_Circ>(&closed_form_)) {
    // Outside of an arc the nearer end is the one fewer degrees away.
    const double middle = 0.5 * (first_ + last_);
    const double t = ElCLib::InPeriod(ElCLib::Parameter(*circle, to_gp(p)), middle - M_PI, middle + M_PI);
    return at(std::clamp(t, first_, last_));
  }
  if (guess_t) {
    double t = within_range(*guess_t);
    if (newton(p, {first_, last_}, t)) return at(t);
  }
  // At a sharp corner where the edge closes, segments on both its sides are as near.
  std::vector<PieceTree::Candidate> candidates;
  segments_->find(p, candidates);
  CurvePoint closest;
  double closest_distance = std::numeric_limits<double>::infinity();
  for (const PieceTree::Candidate& candidate : candidates) {
    const Piece& segment = segments_->piece(candidate.piece);
    const double length = (segment.corners[1] - segment.corners[0]).norm();
    const double part = length > 0.0 ? (candidate.nearest - segment.corners[0]).norm() / length : 0.0;
    double t = segment.low + part * (segment.high - segment.low);
    newton(p, bracket_of(segment), t);
    const CurvePoint found = at(within_range(t));
    const double distance = (found.position - p).norm();
    if (distance >= closest_distance) continue;
    closest_distance = distance;
    closest = found;
  }
  return closest;
}

CurvePoint EdgeProjector::project_between(const Vec3& p, double low, double high, double start) const {
  double t = start;
  newton(p, {low, high}, t);
  return at(t);
}

EdgeProjector::Bracket EdgeProjector::bracket_of(const Piece& segment) const {
  const int last = static_cast<int>(parameters_.size()) - 1, i = segment.number;
  Bracket bracket{parameters_[std::max(i - 1, 0)], parameters_[std::min(i + 2, last)]};
  if (closed_ && last > 1) {
    const double period = last_ - first_;
    if (i == 0) bracket.low = parameters_[last - 1] - period;
    if (i + 1 == last) bracket.high = parameters_[1] + period;
  }
  return bracket;
}

/// Newton's method on the squared distance, which never rises; false where it does not settle.
bool EdgeProjector::newton(const Vec3& p, const Bracket& bracket, double& t) const {
  const gp_Pnt target = to_gp(p);
  const double tolerance = 1e-13 * length_;
  gp_Pnt position;
  gp_Vec d1, d2;
  curve_->D2(within_range(t), position, d1, d2);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const gp_Vec gap(target, position);
    const double slope = gap.Dot(d1), speed2 = d1.SquareMagnitude();
    if (speed2 <= 0.0) return false;
    double curvature = speed2 + gap.Dot(d2);
    if (curvature <= 0.0) curvature = speed2;
    const double wanted = t - slope / curvature;
    const bool wraps = closed_ && bracket.low <= first_ && bracket.high >= last_;
    const double next = wraps ? within_range(wanted) : std::clamp(wanted, bracket.low, bracket.high);
    double step = wraps ? wanted - t : next - t;
    if (std::abs(step) * std::sqrt(speed2) <= tolerance) return true;
    bool lower = false;
    for (int halving = 0; halving < 10 && !lower; ++halving, step *= 0.5) {
      gp_Pnt trial_position;
      const double trial = within_range(t + step);
      curve_->D2(trial, trial_position, d1, d2);
      lower = trial_position.SquareDistance(target) <= gap.SquareMagnitude() * (1.0 + 1e-14);
      if (lower) {
        t = wraps ? trial : t + step;
        position = trial_position;
      }
    }
    // Below this distance rounding alone decides what is lower.
    if (!lower) return std::abs(slope) <= 1e-7 * length_ * std::sqrt(speed2);
  }
  return false;
}

}  // namespace fgmesh::brep
