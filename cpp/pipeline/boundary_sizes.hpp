// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brep/brep_model.hpp"
#include "core/run_control.hpp"
#include "domain/graded_sizes.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// A mesh's boundary and how far it is from the true one, as far as it foretells what meshing finer will
/// want.
class BentBoundary {
 public:
  BentBoundary(const MeshState& state, const BrepModel& model, RunControl& control);

  /// The sizes that an initial mesh of elements of `size` will have on the boundary and inwards from there.
  GradedSizes initial_sizes(double size, double min_size) const;

  /// Those of a mesh no farther than `deviation` from the true boundary.
  GradedSizes deviation_sizes(double deviation, double min_size) const;

  /// The deviation, mm, to which the default `deviation` will be lowered for the volumes' sake.
  double lowered(double deviation) const;

 private:
  /// A facet or a mesh edge along an edge of the shape.
  struct Part {
    std::array<Vec3, 3> corner;
    double beyond = 0.0;     ///< how far the true boundary is from its middle, mm; above zero outward
    double curvature = 0.0;  ///< of the true boundary, 1/mm
    double area = 0.0;       ///< of a facet, mm^2
    int solid = 0;           ///< of a facet; else 0
  };
  Part facet(const Tet& tet, int face) const;
  GradedSizes sizes(double deviation, double least, double turn) const;

  const MeshState& state_;
  const BrepModel& model_;
  std::vector<Part> parts_;
};

}  // namespace fgmesh
