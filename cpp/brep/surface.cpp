// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/surface.hpp"

#include <BRep_Tool.hxx>
#include <ElCLib.hxx>
#include <ElSLib.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <GeomLib.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "brep/occt.hpp"
#include "brep/smoothness.hpp"

namespace fgmesh::brep {

struct SurfaceDerivatives {
  gp_Pnt position;
  gp_Vec u, v, uu, vv, uv;
};

namespace {

ParameterAxis make_axis(double face_low, double face_high, double surface_low, double surface_high,
                        bool periodic, bool closed) {
  if (periodic) {
    const double middle = 0.5 * (face_low + face_high), period = surface_high - surface_low;
    return {middle - 0.5 * period, middle + 0.5 * period, true};
  }
  if (closed) return {surface_low, surface_high, true};
  // A little beyond the face, so that a point outside of it is seen to be there.
  const double margin = 0.05 * (face_high - face_low);
  return {std::max(face_low - margin, surface_low), std::min(face_high + margin, surface_high), false};
}

/// Whether a surface that is closed in a direction has a sharp edge where it closes.
bool is_sharp_seam(const Geom_Surface& surface, int direction, double low, double high, double other_low,
                   double other_high) {
  constexpr int kProbes = 5;
  for (int i = 1; i <= kProbes; ++i) {
    const double other = other_low + (other_high - other_low) * i / (kProbes + 1);
    const gp_Pnt2d a = direction == 0 ? gp_Pnt2d(low, other) : gp_Pnt2d(other, low),
                   b = direction == 0 ? gp_Pnt2d(high, other) : gp_Pnt2d(other, high);
    if (!normals_agree(surface, a, b)) return true;
  }
  return false;
}

/// Minimiser of the quadratic model of half the squared distance; Gauss-Newton where the model is no bowl.
std::array<double, 2> newton_step(const SurfaceDerivatives& d, const gp_Vec& gap,
                                  const std::array<bool, 2>& fixed) {
  const double g_u = fixed[0] ? 0.0 : gap.Dot(d.u), g_v = fixed[1] ? 0.0 : gap.Dot(d.v);
  const double e = d.u.SquareMagnitude(), f = d.u.Dot(d.v), g = d.v.SquareMagnitude();
  double a = e + gap.Dot(d.uu), b = f + gap.Dot(d.uv), c = g + gap.Dot(d.vv);
  const bool bowl = a > 0.0 && c > 0.0 && a * c - b * b > 1e-6 * a * c;
  if (!bowl) {
    // The added share keeps the step finite where the two tangents are parallel.
    a = e * (1.0 + 1e-9);
    b = f;
    c = g * (1.0 + 1e-9);
  }
  if (fixed[0] || fixed[1]) b = 0.0;
  const double determinant = a * c - b * b;
  const double tiny = 1e-30 * std::max(e * e, g * g);
  if (fixed[0] || determinant <= tiny)
    return {fixed[0] || e <= 0.0 ? 0.0 : -g_u / e, g > 0.0 ? -g_v / g : 0.0};
  if (fixed[1]) return {-g_u / a, 0.0};
  return {(b * g_v - c * g_u) / determinant, (b * g_u - a * g_v) / determinant};
}

/// ElSLib takes the nappe on the point's side of the tip; a face lies on one, whichever side the point is on.
void closest_on_cone(const gp_Cone& cone, const gp_Pnt& p, double v_on_face, double& u, double& v) {
  const gp_Ax3& frame = cone.Position();
  const gp_Vec local(frame.Location(), p);
  const double sine = std::sin(cone.SemiAngle()), cosine = std::cos(cone.SemiAngle());
  const double nappe = cone.RefRadius() + v_on_face * sine >= 0.0 ? 1.0 : -1.0;
  const double x = nappe * local.Dot(frame.XDirection()), y = nappe * local.Dot(frame.YDirection());
  u = std::atan2(y, x);
  v = (nappe * std::hypot(x, y) - cone.RefRadius()) * sine + local.Dot(frame.Direction()) * cosine;
}

}  // namespace

double ParameterAxis::bring(double x) const {
  if (x >= low && x <= high) return x;
  return closed ? ElCLib::InPeriod(x, low, high) : std::clamp(x, low, high);
}

Surface::Surface(const TopoDS_Face& face, const Uv& low, const Uv& high)
    : geometry_(BRep_Tool::Surface(face)) {
  while (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(geometry_)) {
    geometry_ = trimmed->BasisSurface();
  }
  const GeomAdaptor_Surface adaptor(geometry_);
  switch (adaptor.GetType()) {
    case GeomAbs_Plane:
      closed_form_ = adaptor.Plane();
      break;
    case GeomAbs_Cylinder:
      closed_form_ = adaptor.Cylinder();
      break;
    case GeomAbs_Cone:
      closed_form_ = adaptor.Cone();
      break;
    case GeomAbs_Sphere:
      closed_form_ = adaptor.Sphere();
      break;
    case GeomAbs_Torus:
      // One that crosses itself has points with two sheets about as near.
      if (adaptor.Torus().MajorRadius() > adaptor.Torus().MinorRadius()) closed_form_ = adaptor.Torus();
      break;
    default:
      break;
  }
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(geometry_)) {
    constexpr int kMostSpans = 20000;  // some hundred bytes each
    if ((spline->NbUKnots() - 1) * (spline->NbVKnots() - 1) <= kMostSpans) spans_ = SplineSpans(*spline);
  }
  double u_low = 0.0, u_high = 0.0, v_low = 0.0, v_high = 0.0;
  geometry_->Bounds(u_low, u_high, v_low, v_high);
  // Not closed across a sharp edge: Newton's method would not settle there.
  const bool u_closed =
      geometry_->IsUClosed() && !is_sharp_seam(*geometry_, 0, u_low, u_high, low[1], high[1]);
  const bool v_closed =
      geometry_->IsVClosed() && !is_sharp_seam(*geometry_, 1, v_low, v_high, low[0], high[0]);
  axes_[0] = make_axis(low[0], high[0], u_low, u_high, u_closed && geometry_->IsUPeriodic(), u_closed);
  axes_[1] = make_axis(low[1], high[1], v_low, v_high, v_closed && geometry_->IsVPeriodic(), v_closed);
  const Vec3 corner = position(low);
  for (const Uv& other :
       {Uv{high[0], low[1]}, high, Uv{0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])}}) {
    size_ = std::max(size_, (position(other) - corner).norm());
  }
}

Uv Surface::closest_by_form(const Vec3& p) const {
  double u = 0.0, v = 0.0;
  std::visit(
      [&](const auto& form) {
        using Form = std::decay_t<decltype(form)>;
        if constexpr (std::is_same_v<Form, gp_Cone>) {
          closest_on_cone(form, to_gp(p), 0.5 * (axes_[1].low + axes_[1].high), u, v);
        } else if constexpr (!std::is_same_v<Form, std::monostate>) {
          ElSLib::Parameters(form, to_gp(p), u, v);
        }
      },
      closed_form_);
  // Not clamped: a point beyond the face must be seen to be there.
  return {axes_[0].closed ? axes_[0].bring(u) : u, axes_[1].closed ? axes_[1].bring(v) : v};
}

bool Surface::closest_from(const Vec3& p, Uv& uv) const {
  const gp_Pnt target = to_gp(p);
  uv = bring(uv[0], uv[1]);
  SurfaceDerivatives d = d2(uv);
  for (int iteration = 0; iteration < 40; ++iteration) {
    const gp_Vec gap(target, d.position);
    const std::array<double, 2> slope{gap.Dot(d.u), gap.Dot(d.v)};
    std::array<bool, 2> fixed{};
    for (int k = 0; k < 2; ++k) {
      const bool held_low = uv[k] <= axes_[k].low && slope[k] > 0.0;
      const bool held_high = uv[k] >= axes_[k].high && slope[k] < 0.0;
      fixed[k] = !axes_[k].closed && (held_low || held_high);
    }
    std::array<double, 2> step = newton_step(d, gap, fixed);
    for (int k = 0; k < 2; ++k) {
      const double longest = 0.25 * (axes_[k].high - axes_[k].low);
      step[k] = std::clamp(step[k], -longest, longest);
    }
    const double reach = (d.u * step[0] + d.v * step[1]).Magnitude();
    if (reach <= 1e-12 * size_) return true;

    const double distance2 = gap.SquareMagnitude();
    bool lower = false;
    for (int halving = 0; halving < 12 && !lower; ++halving) {
      const Uv trial = bring(uv[0] + step[0], uv[1] + step[1]);
      const SurfaceDerivatives trial_d = d2(trial);
      lower = trial_d.position.SquareDistance(target) <= distance2 * (1.0 + 1e-14);
      if (lower) {
        uv = trial;
        d = trial_d;
      }
      // Below this reach rounding decides what is lower, and where surfaces are not quite smooth, nothing is.
      if (!lower && reach <= 1e-7 * size_) return true;
      for (double& s : step) s *= 0.5;
    }
    if (!lower) return false;
  }
  return false;
}

void Surface::closest_by_search(const Vec3& p, Uv& uv) const {
  try {
    const GeomAPI_ProjectPointOnSurf search(to_gp(p), geometry_, axes_[0].low, axes_[0].high, axes_[1].low,
                                            axes_[1].high);
    if (search.NbPoints() == 0 || search.LowerDistance() >= (position(uv) - p).norm()) return;
    search.LowerDistanceParameters(uv[0], uv[1]);
  } catch (const Standard_Failure&) {
    // What Newton's method found stands.
  }
}

void Surface::d1(const Uv& at, gp_Pnt& position, gp_Vec& du, gp_Vec& dv) const {
  spans_.empty() ? geometry_->D1(at[0], at[1], position, du, dv)
                 : spans_.at(at[0], at[1]).D1(at[0], at[1], position, du, dv);
}

SurfaceDerivatives Surface::d2(const Uv& at) const {
  SurfaceDerivatives d;
  spans_.empty() ? geometry_->D2(at[0], at[1], d.position, d.u, d.v, d.uu, d.vv, d.uv)
                 : spans_.at(at[0], at[1]).D2(at[0], at[1], d.position, d.u, d.v, d.uu, d.vv, d.uv);
  return d;
}

Vec3 Surface::position(const Uv& uv) const {
  gp_Pnt position;
  spans_.empty() ? geometry_->D0(uv[0], uv[1], position) : spans_.at(uv[0], uv[1]).D0(uv[0], uv[1], position);
  return to_vec3(position);
}

Vec3 Surface::position(const Uv& uv, Vec3& normal) const {
  gp_Pnt position;
  gp_Vec du, dv;
  d1(uv, position, du, dv);
  normal = to_vec3(du.Crossed(dv));
  const double length = normal.norm();
  const double scale = std::max(du.SquareMagnitude(), dv.SquareMagnitude());
  if (length > 1e-9 * scale) {
    normal /= length;
  } else {
    gp_Dir limit;
    const bool exists = GeomLib::NormEstim(geometry_, {uv[0], uv[1]}, 1e-9 * scale, limit) < 2;
    normal = exists ? to_vec3(gp_Vec(limit)) : Vec3::Zero().eval();
  }
  return to_vec3(position);
}

}  // namespace fgmesh::brep
