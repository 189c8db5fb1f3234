// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>
#include <variant>

#include "brep/spline_spans.hpp"
#include "core/vec3.hpp"

namespace fgmesh::brep {

using Uv = std::array<double, 2>;

/// One direction of a face's parameter plane.
struct ParameterAxis {
  double low = 0.0, high = 0.0;  ///< where it is closed: one turn; else as far as a search may go
  bool closed = false;

  /// `x` moved by whole turns, or clamped, into [low, high].
  double bring(double x) const;
};

struct SurfaceDerivatives;

/// The surface under a face, without its trimming. Immutable and safe to share between threads: evaluates the
/// Geom_Surface itself, since the caches of OpenCASCADE's adaptors are not.
class Surface {
 public:
  /// `low` and `high` are the corners of the face in the parameter plane.
  Surface(const TopoDS_Face& face, const Uv& low, const Uv& high);

  const ParameterAxis& axis(int direction) const { return axes_[direction]; }
  const Handle(Geom_Surface) & geometry() const { return geometry_; }

  /// Planes, cylinders, cones, balls and tori: the closest point is known at once.
  bool has_closed_form() const { return closed_form_.index() != 0; }
  Uv closest_by_form(const Vec3& p) const;

  /// Closest point by Newton's method from `uv`; false where it does not settle. Never farther than the
  /// start.
  bool closest_from(const Vec3& p, Uv& uv) const;

  /// Closest point by a search over the whole surface within the axes; slow. `uv` stays where nothing closer
  /// is found.
  void closest_by_search(const Vec3& p, Uv& uv) const;

  Vec3 position(const Uv& uv) const;

  /// Position, and the unit vector along dS/du x dS/dv: its limit at a pole, zero at the tip of a cone.
  Vec3 position(const Uv& uv, Vec3& normal) const;

 private:
  void d1(const Uv& at, gp_Pnt& position, gp_Vec& du, gp_Vec& dv) const;
  SurfaceDerivatives d2(const Uv& at) const;
  Uv bring(double u, double v) const { return {axes_[0].bring(u), axes_[1].bring(v)}; }

  Handle(Geom_Surface) geometry_;
  SplineSpans spans_;  ///< of a B-spline surface
  std::variant<std::monostate, gp_Pln, gp_Cylinder, gp_Cone, gp_Sphere, gp_Torus> closed_form_;
  std::array<ParameterAxis, 2> axes_;
  double size_ = 0.0;  ///< diagonal of the face's rough extent, mm
};

}  // namespace fgmesh::brep
