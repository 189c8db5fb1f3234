// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/reference.hpp"
#include "material/formula_program.hpp"
#include "material/frame_coordinates.hpp"
#include "material/sampled_table.hpp"

namespace fgmesh {

/// All that a formula may read at points of the world: coordinates in a frame, distances to references
/// and values of tables.
class PointVariables final : public PointInputs {
 public:
  /// `distances`: those to the references at the points where they are known, one row a point; duals() then
  /// serves no distances.
  PointVariables(const Frame& frame, const std::vector<Reference>& references, const Tables& tables,
                 const Vec3* points, const double* distances = nullptr)
      : coordinates_(frame, points),
        references_(references),
        tables_(tables),
        points_(points),
        distances_(distances) {}

  void values(Variable variable, std::size_t first, std::size_t count, double* out) const override;

  /// Gradients in the world's axes.
  void duals(Variable variable, std::size_t first, std::size_t count, std::size_t stride,
             double* out) const override;

 private:
  void table_values(const SampledTable& table, std::size_t first, std::size_t count, double* out) const;
  void table_duals(const SampledTable& table, std::size_t first, std::size_t count, std::size_t stride,
                   double* out) const;

  FrameCoordinates coordinates_;
  const std::vector<Reference>& references_;
  const Tables& tables_;
  const Vec3* points_;
  const double* distances_;
};

/// What `variable` can be within a box of the world.
Interval variable_bounds(const Frame& frame, const std::vector<Reference>& references, const Tables& tables,
                         const Box& box, Variable variable);

/// The same within a tetrahedron, with its slopes along the world's axes.
DualInterval variable_tet_bounds(const Frame& frame, const std::vector<Reference>& references,
                                 const Tables& tables, const Corners& tet, Variable variable);

}  // namespace fgmesh
