// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/unmet_criteria.hpp"

#include <algorithm>
#include <sstream>

#include "core/error.hpp"
#include "mesh/steiner_points.hpp"

namespace fgmesh {

std::string describe_misses(const MeshingResult& result, const CompositionField& field,
                            const MeshingOptions& options) {
  const auto worst =
      std::max_element(result.variation.begin(), result.variation.end()) - result.variation.begin();
  const auto& tet = result.mesh.tets[worst];
  Vec3 low = result.mesh.points[tet[0]], high = low, centre = Vec3::Zero();
  for (const std::int32_t t : result.above_threshold) {
    for (const std::int32_t v : result.mesh.tets[t]) {
      low = low.cwiseMin(result.mesh.points[v]);
      high = high.cwiseMax(result.mesh.points[v]);
    }
  }
  bool jump = false;
  for (const std::int32_t a : tet) {
    centre += 0.25 * result.mesh.points[a];
    for (const std::int32_t b : tet)
      jump = jump || (a < b && jumps_between(field, result.mesh.points[a], result.mesh.points[b],
                                             options.material_threshold));
  }
  std::ostringstream text;
  text << result.above_threshold.size() << " of " << result.mesh.tets.size()
       << " tetrahedra stay above the threshold " << options.material_threshold << ", within " << Shown{low}
       << " to " << Shown{high} << " mm; the worst varies by " << result.variation[worst] << " at "
       << Shown{centre} << ". ";
  if (jump) {
    text << "The volume fraction jumps there, so no mesh can keep the threshold: split the solid at the "
            "jump, or "
            "smooth it (smoothstep).";
  } else {
    text << "Refinement stopped at the smallest size, " << options.min_size
         << " mm, or at the largest mesh allowed: lower MinSize, split the solid or raise the threshold.";
  }
  return text.str();
}

std::string describe_straightened(const MeshingResult& result) {
  const SecondOrderMesh& mesh = result.second_order;
  Vec3 low = mesh.points[mesh.straightened[0]], high = low;
  for (const std::int32_t node : mesh.straightened) {
    low = low.cwiseMin(mesh.points[node]);
    high = high.cwiseMax(mesh.points[node]);
  }
  const auto kept = std::count_if(mesh.carriers.begin() + result.mesh.points.size(), mesh.carriers.end(),
                                  [](const Carrier& carrier) { return carrier.dimension < 3; });
  std::ostringstream text;
  text << mesh.straightened.size() << " of " << kept + mesh.straightened.size()
       << " middle nodes of boundary edges stay off the true boundary, within " << Shown{low} << " to "
       << Shown{high} << " mm, since curved tetrahedra would be turned over there: lower SurfaceDeviation or "
       << "MaxSize";
  return text.str();
}

}  // namespace fgmesh
