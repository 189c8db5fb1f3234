// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "domain/sizing_field.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// The space in which elements that are to be longer across the gradient of f than along it are alike in all
/// directions: lengths along one axis count `factor` times. It is the metric M = h^-2 (n n^T + (I - n n^T) /
/// a^2) of anisotropic Delaunay triangulation (Chen and Xu 2004), but for its scale.
class Stretch {
 public:
  /// The mean of the vertices' own. Where their axes disagree, as at an extremum of f, little is left of it.
  Stretch(std::initializer_list<const Vertex*> vertices) {
    Vec3 sum = Vec3::Zero();
    for (const Vertex* vertex : vertices) sum += vertex->stretch;
    const double length = sum.norm();
    if (length == 0.0) return;
    axis_ = sum / length;
    factor_ = 1.0 + length / static_cast<double>(vertices.size());
  }

  double factor() const { return factor_; }
  const Vec3& axis() const { return axis_; }  ///< zero where the factor is 1
  Vec3 back(const Vec3& way) const { return way + (1.0 / factor_ - 1.0) * axis_.dot(way) * axis_; }
  double squared_length(const Vec3& way) const {
    const double along = axis_.dot(way);
    return way.squaredNorm() + (factor_ * factor_ - 1.0) * along * along;
  }

 private:
  Vec3 axis_ = Vec3::Zero();
  double factor_ = 1.0;
};

/// The way between two vertices in the stretched space of the first. Level sets of f that are bent around a
/// point are spheres there, too, of a radius as much larger. A stretch of the way alone would make them more
/// bent than their distances are, and smoothing would drive vertices inwards.
Vec3 way_in_layers(const Vertex& from, const Vertex& to);

/// A tetrahedron in the stretched space. Each edge is as long as its two ends make it, so that tetrahedra
/// that share it agree.
struct StretchedTet {
  /// Six times the volume before it is stretched, mm^3: those of all fillings of one hole have the same sum.
  double volume = 0.0;
  double factor = 1.0;         ///< by which the volume grows
  double squared_edges = 0.0;  ///< sum, stretched, mm^2

  StretchedTet(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d);
  /// 0.048 of a regular one, below zero where it is turned over.
  double flatness() const { return factor * volume / (squared_edges * std::sqrt(squared_edges)); }
};

/// Vertex::stretch where elements are to have `size` along the gradient: they may be `sizing.anisotropy`
/// times longer across it, less where level sets of f are bent or the largest size is in the way.
Vec3 stretch_at(const CompositionField& field, const Vec3& place, const Vec3& gradient, double size,
                const SizingField& sizing);

/// Fills Vertex::stretch, by Vertex::size.
void update_stretches(MeshState& state, const SizingField& sizing);

}  // namespace fgmesh
