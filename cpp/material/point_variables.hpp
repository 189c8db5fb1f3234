// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reference.hpp"
#include "material/formula_program.hpp"
#include "material/frame_coordinates.hpp"

namespace fgmesh {

/// All that a formula may read at points of the world: coordinates in a frame and distances to references.
class PointVariables final : public PointInputs {
 public:
  /// `distances`: those to the references at the points where they are known, one row a point; duals() then
  /// serves coordinates only.
  PointVariables(const Frame& frame, const std::vector<Reference>& references, const Vec3* points,
                 const double* distances = nullptr)
      : coordinates_(frame, points), references_(references), points_(points), distances_(distances) {}

  void values(Variable variable, std::size_t first, std::size_t count, double* out) const override;

  /// Gradients in the world's axes.
  void duals(Variable variable, std::size_t first, std::size_t count, std::size_t stride,
             double* out) const override;

 private:
  FrameCoordinates coordinates_;
  const std::vector<Reference>& references_;
  const Vec3* points_;
  const double* distances_;
};

/// What `variable` can be within a box of the world.
Interval variable_bounds(const Frame& frame, const std::vector<Reference>& references, const Box& box,
                         Variable variable);

}  // namespace fgmesh
