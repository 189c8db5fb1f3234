// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Geom2d_Curve.hxx>
#include <array>
#include <vector>

#include "brep/brep_model.hpp"
#include "brep/shape_check.hpp"
#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"

namespace fgmesh::brep {

/// A piece of a face's boundary in its (u, v) plane, between two sample points of an edge.
struct BorderSegment {
  std::array<double, 2> start{}, end{};
  std::array<double, 2> bulge{};  ///< how far the true border may lie beside the middle of the segment
  bool free = true;  ///< the face ends here; false on seams and poles, where it goes on elsewhere in (u, v)
  Handle(Geom2d_Curve) curve;          ///< the true border; null where OpenCASCADE has none
  std::array<double, 2> parameters{};  ///< on it, of `start` and `end`
};

struct FaceSamples {
  std::vector<Vec3> points;
  std::vector<std::array<double, 2>>
      uv;  ///< of each point; several points may meet in space at seams and poles
  std::vector<std::array<int, 3>> triangles;
  std::vector<BorderSegment> border;
};

/// The sampled boundary, and what projection starts from.
struct Sampling {
  SampledBoundary boundary;
  std::vector<FaceSamples> faces;  ///< of FaceN at n - 1; empty for faces that bound no solid
  std::vector<std::vector<double>> edge_parameters;  ///< of EdgeN at n - 1, ascending
};

/// Triangulates the faces and welds them along their edges. Where a face fails, or triangles do not meet or
/// bound another volume than their faces do, other and finer deflections are tried.
/// Throws GeometryError that names the face which cannot be triangulated; Cancelled.
Sampling sample_boundary(const CheckedShape& shape, const SamplingOptions& options, RunControl& control);

}  // namespace fgmesh::brep
