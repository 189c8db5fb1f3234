// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"

namespace fgmesh {

/// Throws GeometryError that names two faces which cross or touch each other away from their borders, or one
/// that crosses itself; Cancelled. Where samples cut each other the true faces decide: walls that are thinner
/// than the samples are exact do not count.
void require_no_crossing_faces(const SampledBoundary& samples, const BoundaryGeometry& boundary,
                               RunControl& control);

}  // namespace fgmesh
