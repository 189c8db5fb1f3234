// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brep/edge_projector.hpp"
#include "brep/face_projector.hpp"
#include "brep/sampling.hpp"
#include "brep/topology.hpp"
#include "core/run_control.hpp"

namespace fgmesh::brep {

/// Projections to every face and edge that bounds a solid; nothing stands for the others. The faces know the
/// edges by their place in memory: to be moved, not copied.
struct Projections {
  std::vector<std::optional<EdgeProjector>> edges;  ///< of EdgeN at n - 1
  std::vector<std::optional<FaceProjector>> faces;  ///< of FaceN at n - 1

  Projections() = default;
  /// Throws Cancelled.
  Projections(const Topology& topology, const Sampling& sampling, RunControl& control);
  Projections(Projections&&) = default;
  Projections& operator=(Projections&&) = default;
};

}  // namespace fgmesh::brep
