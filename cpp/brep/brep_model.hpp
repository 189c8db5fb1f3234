// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"

namespace fgmesh {

struct SamplingOptions {
  /// Largest distance of a sample triangle to its face, mm; 0: the diagonal of the part / 2000.
  double deflection = 0.0;
  /// Largest angle between neighbouring sample triangles of a face, radians.
  double angle = 0.2;
};

/// A checked OpenCASCADE shape behind an interface that shows no OCCT: one or more valid, closed solids, numbered
/// as FreeCAD numbers them (TopExp::MapShapes order of the whole shape).
class BrepModel final : public BoundaryGeometry {
 public:
  /// Reads the text of a BREP or STEP file (told apart by its first bytes) and checks it.
  /// Throws InvalidInput where the text is neither, is empty or cut short; GeometryError where the shape holds no
  /// solid, an open shell, a solid without volume or an invalid sub-shape, naming it.
  static BrepModel from_text(const std::string& text, RunControl& control);

  /// Samples the boundary finely. `options` must stay coarser than nothing: the finer, the closer the first
  /// guess of project_to_face().
  SampledBoundary sample(const SamplingOptions& options, RunControl& control);

  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess_uv = nullptr) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess_t = nullptr) const override;
  Vec3 vertex_position(int vertex) const override;
  bool contains(const Vec3& p) const override;

  BrepModel(BrepModel&&) noexcept;
  ~BrepModel() override;

 private:
  struct State;
  explicit BrepModel(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fgmesh
