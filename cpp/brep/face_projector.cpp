// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/face_projector.hpp"

#include <BRepClass_FaceClassifier.hxx>
#include <BRep_Tool.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "brep/occt.hpp"

namespace fgmesh::brep {

FaceProjector::FaceProjector(const Topology& topology, int face, const FaceSamples& samples,
                             const std::vector<std::optional<EdgeProjector>>& edges)
    : face_(topology.face(face)),
      reversed_(topology.face_use(face).reversed),
      domain_(samples),
      surface_(face_, domain_.low(), domain_.high()) {
  if (!surface_.has_closed_form()) {
    sample_uv_ = samples.uv;
    sample_triangles_ = samples.triangles;
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < samples.triangles.size(); ++i) {
      const auto& [a, b, c] = samples.triangles[i];
      Piece& piece = pieces.emplace_back();
      piece.corners = {samples.points[a], samples.points[b], samples.points[c]};
      piece.number = static_cast<int>(i);
    }
    samples_.emplace(std::move(pieces));
  }
  for (TopExp_Explorer it(face_, TopAbs_EDGE); it.More(); it.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(it.Current());
    const int number = topology.edge_number(edge);
    const EdgeUse& use = topology.edge_use(number);
    if (use.count == 0 || use.seam) continue;
    Border border{use.degenerate ? nullptr : &*edges[number - 1], {}, 0.0, 0.0};
    border.curve = BRep_Tool::CurveOnSurface(edge, face_, border.first, border.last);
    if (!border.curve.IsNull()) borders_.push_back(border);
  }
}

SurfacePoint FaceProjector::project(const Vec3& p, const double* guess_uv) const {
  Uv uv = closest_on_surface(p, guess_uv);
  if (!covers(uv) && !borders_.empty()) uv = closest_on_border(p);
  return at(uv);
}

SurfacePoint FaceProjector::project_to_surface(const Vec3& p, const Vec3& near, bool& covered) const {
  Uv uv{};
  if (surface_.has_closed_form()) {
    uv = surface_.closest_by_form(p);
  } else {
    uv = nearest_sample(near);
    surface_.closest_from(p, uv);
  }
  covered = covers(uv);
  return at(uv);
}

std::array<double, 2> FaceProjector::curvatures(const Vec3& near) const {
  const Uv uv = nearest_sample(near);
  GeomLProp_SLProps properties(surface_.geometry(), uv[0], uv[1], 2, Precision::Confusion());
  if (!properties.IsCurvatureDefined()) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return {kInfinity, kInfinity};
  }
  // OpenCASCADE's are above zero where the surface bends towards dS/du x dS/dv.
  const double along = std::max(properties.MaxCurvature(), properties.MinCurvature());
  const double against = -std::min(properties.MaxCurvature(), properties.MinCurvature());
  return reversed_ ? std::array{against, along} : std::array{along, against};
}

SurfacePoint FaceProjector::at(const Uv& uv) const {
  SurfacePoint found;
  found.position = surface_.position(uv, found.normal);
  if (reversed_) found.normal = -found.normal;
  found.u = uv[0];
  found.v = uv[1];
  return found;
}

Uv FaceProjector::closest_on_surface(const Vec3& p, const double* guess_uv) const {
  if (surface_.has_closed_form()) return surface_.closest_by_form(p);
  if (guess_uv) {
    Uv uv{guess_uv[0], guess_uv[1]};
    if (surface_.closest_from(p, uv)) return uv;
  }
  // At a seam, which may be sharp, triangles of both its sides are as near.
  std::vector<PieceTree::Candidate> candidates;
  samples_->find(p, candidates);
  Uv closest{};
  double closest_distance = std::numeric_limits<double>::infinity();
  for (const PieceTree::Candidate& candidate : candidates) {
    Uv uv = uv_of(candidate);
    if (!surface_.closest_from(p, uv)) surface_.closest_by_search(p, uv);
    const double distance = (surface_.position(uv) - p).norm();
    if (distance >= closest_distance) continue;
    closest_distance = distance;
    closest = uv;
  }
  return closest;
}

Uv FaceProjector::uv_of(const PieceTree::Candidate& candidate) const {
  const Piece& piece = samples_->piece(candidate.piece);
  const auto& [a, b, c] = piece.corners;
  const auto& [ia, ib, ic] = sample_triangles_[piece.number];
  // Barycentric coordinates; those of the first corner where the triangle is flat.
  const Vec3 area = (b - a).cross(c - a), at = candidate.nearest - a;
  const double squared = area.squaredNorm();
  const double at_b = squared > 0.0 ? at.cross(c - a).dot(area) / squared : 0.0,
               at_c = squared > 0.0 ? (b - a).cross(at).dot(area) / squared : 0.0;
  Uv uv;
  for (int k = 0; k < 2; ++k)
    uv[k] = (1.0 - at_b - at_c) * sample_uv_[ia][k] + at_b * sample_uv_[ib][k] + at_c * sample_uv_[ic][k];
  return uv;
}

Uv FaceProjector::nearest_sample(const Vec3& p) const {
  std::vector<PieceTree::Candidate> candidates;
  samples_->find(p, candidates);
  return uv_of(candidates.front());
}

bool FaceProjector::covers(Uv& uv) const {
  if (covers_exactly(uv)) return true;
  // A face may wind about its surface several times, as the crest of a thread does.
  for (int k = 0; k < 2; ++k) {
    const ParameterAxis& axis = surface_.axis(k);
    const double turn = axis.high - axis.low;
    if (!axis.closed || domain_.high()[k] - domain_.low()[k] <= turn) continue;
    Uv turned = uv;
    for (turned[k] -= turn * std::floor((uv[k] - domain_.low()[k]) / turn); turned[k] <= domain_.high()[k];
         turned[k] += turn) {
      if (!covers_exactly(turned)) continue;
      uv = turned;
      return true;
    }
  }
  return false;
}

bool FaceProjector::covers_exactly(const Uv& uv) const {
  const FaceDomain::Place place = domain_.locate(uv);
  if (place != FaceDomain::Place::border) return place == FaceDomain::Place::inside;
  const BRepClass_FaceClassifier classifier(face_, gp_Pnt2d(uv[0], uv[1]), Precision::PConfusion());
  return classifier.State() != TopAbs_OUT;
}

Uv FaceProjector::closest_on_border(const Vec3& p) const {
  Uv closest{};
  double closest_distance = std::numeric_limits<double>::infinity();
  for (const Border& border : borders_) {
    const double t = border.edge ? border.edge->project(p).t : border.first;
    const gp_Pnt2d uv = border.curve->Value(t);
    const double distance = (surface_.position({uv.X(), uv.Y()}) - p).norm();
    if (distance >= closest_distance) continue;
    closest_distance = distance;
    closest = {uv.X(), uv.Y()};
  }
  return closest;
}

}  // namespace fgmesh::brep
