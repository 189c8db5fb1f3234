// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <optional>
#include <vector>

#include "brep/edge_projector.hpp"
#include "brep/face_domain.hpp"
#include "brep/piece_tree.hpp"
#include "brep/sampling.hpp"
#include "brep/surface.hpp"
#include "brep/topology.hpp"
#include "core/boundary_geometry.hpp"

namespace fgmesh::brep {

/// Closest points on one face. Immutable, so safe to share between threads.
class FaceProjector {
 public:
  /// `edges` are those of the whole shape (of EdgeN at n - 1) and must outlive this object.
  FaceProjector(const Topology& topology, int face, const FaceSamples& samples,
                const std::vector<std::optional<EdgeProjector>>& edges);

  SurfacePoint project(const Vec3& p, const double* guess_uv = nullptr) const;

  /// Planes, cylinders, cones, balls and tori.
  bool has_closed_form() const { return surface_.has_closed_form(); }

  /// Closest point of the surface without its borders: the closest of all where there is a closed form, else
  /// the one to which the distance falls from the sample triangle nearest to `near`. `covered`: it lies on
  /// the face.
  SurfacePoint project_to_surface(const Vec3& p, const Vec3& near, bool& covered) const;

  /// How much the surface bends towards its outer and its inner side beside the sample triangle nearest to
  /// `near`, 1/mm: the largest of the curvatures, below zero where all turn away; infinite where they are not
  /// defined. For surfaces without a closed form.
  std::array<double, 2> curvatures(const Vec3& near) const;

 private:
  struct Border {
    const EdgeProjector* edge;   ///< null for a pole
    Handle(Geom2d_Curve) curve;  ///< the edge in the parameter plane
    double first, last;
  };

  SurfacePoint at(const Uv& uv) const;
  Uv closest_on_surface(const Vec3& p, const double* guess_uv) const;
  /// Where the sample triangle of a candidate has its nearest point.
  Uv uv_of(const PieceTree::Candidate& candidate) const;
  Uv nearest_sample(const Vec3& p) const;
  /// Whether the face has the point of its surface; `uv` is moved by whole turns to where it has it.
  bool covers(Uv& uv) const;
  bool covers_exactly(const Uv& uv) const;
  Uv closest_on_border(const Vec3& p) const;

  TopoDS_Face face_;
  bool reversed_ = false;
  FaceDomain domain_;
  Surface surface_;
  std::vector<Uv> sample_uv_;
  std::vector<std::array<int, 3>> sample_triangles_;
  std::optional<PieceTree> samples_;
  std::vector<Border> borders_;
};

}  // namespace fgmesh::brep
