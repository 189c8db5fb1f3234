// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <TopoDS_Face.hxx>
#include <optional>
#include <vector>

#include "brep/edge_projector.hpp"
#include "brep/face_domain.hpp"
#include "brep/nearest_point.hpp"
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

 private:
  struct Border {
    const EdgeProjector* edge;   ///< null for a pole
    Handle(Geom2d_Curve) curve;  ///< the edge in the parameter plane
    double first, last;
  };

  Uv closest_on_surface(const Vec3& p, const double* guess_uv) const;
  bool covers(const Uv& uv) const;
  Uv closest_on_border(const Vec3& p) const;

  TopoDS_Face face_;
  bool reversed_ = false;
  FaceDomain domain_;
  Surface surface_;
  std::vector<Uv> sample_uv_;
  NearestPoint nearest_;
  std::vector<Border> borders_;
};

}  // namespace fgmesh::brep
