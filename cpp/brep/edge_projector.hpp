// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <optional>
#include <variant>
#include <vector>

#include "brep/piece_tree.hpp"
#include "core/boundary_geometry.hpp"

namespace fgmesh::brep {

/// Closest points on the curve of one edge. Immutable, so safe to share between threads: it evaluates the
/// Geom_Curve itself, not an adaptor, whose cache is not.
class EdgeProjector {
 public:
  /// `parameters` are those of the edge's samples, ascending from its first to its last end.
  EdgeProjector(const TopoDS_Edge& edge, std::vector<double> parameters);

  CurvePoint project(const Vec3& p, const double* guess_t = nullptr) const;

  /// Lines and circles: project() gives the closest point of all. On others it may miss one that is closer by
  /// less than the samples are off the curve.
  bool has_closed_form() const { return closed_form_.index() != 0; }

  /// The point between the parameters `low` and `high` to which the distance falls from `start`.
  CurvePoint project_between(const Vec3& p, double low, double high, double start) const;

  CurvePoint at(double t) const;
  const std::vector<double>& parameters() const { return parameters_; }

 private:
  struct Bracket {
    double low, high;
  };

  /// Around a segment between two samples.
  Bracket bracket_of(const Piece& segment) const;
  bool newton(const Vec3& p, const Bracket& bracket, double& t) const;
  double within_range(double t) const;

  double first_ = 0.0, last_ = 0.0;  // before curve_, whose making sets them
  Handle(Geom_Curve) curve_;
  std::variant<std::monostate, gp_Lin, gp_Circ> closed_form_;
  bool closed_ = false;  ///< and smooth there
  double length_ = 0.0;  ///< of the polygon of samples
  std::vector<double> parameters_;
  std::optional<PieceTree> segments_;
};

}  // namespace fgmesh::brep
