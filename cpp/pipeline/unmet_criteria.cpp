// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/unmet_criteria.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "core/error.hpp"
#include "mesh/steiner_points.hpp"

namespace fgmesh {
namespace {

/// Holds the given tetrahedra, one at least.
Box box_around(const TetMesh& mesh, const std::vector<std::int32_t>& tets) {
  const Vec3& first = mesh.points[mesh.tets[tets.front()][0]];
  Box box{first, first};
  for (const std::int32_t t : tets) {
    for (const std::int32_t v : mesh.tets[t]) {
      box.low = box.low.cwiseMin(mesh.points[v]);
      box.high = box.high.cwiseMax(mesh.points[v]);
    }
  }
  return box;
}

}  // namespace

std::string describe_misses(const MeshingResult& result, const CompositionField& field,
                            const MeshingOptions& options) {
  const auto worst =
      std::max_element(result.variation.begin(), result.variation.end()) - result.variation.begin();
  const auto& tet = result.mesh.tets[worst];
  const Box box = box_around(result.mesh, result.above_threshold);
  Vec3 centre = Vec3::Zero();
  bool jump = false;
  for (const std::int32_t a : tet) {
    centre += 0.25 * result.mesh.points[a];
    for (const std::int32_t b : tet)
      jump = jump || (a < b && jumps_between(field, result.mesh.points[a], result.mesh.points[b],
                                             options.material_threshold));
  }
  std::ostringstream text;
  text << result.above_threshold.size() << " of " << result.mesh.tets.size()
       << " tetrahedra stay above the threshold " << options.material_threshold << ", within "
       << Shown{box.low} << " to " << Shown{box.high} << " mm; the worst varies by "
       << result.variation[worst] << " at " << Shown{centre} << ". ";
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

std::string describe_certificate(const MeshingResult& result, const MeshingOptions& options) {
  std::vector<std::int32_t> hidden;
  std::set_difference(result.broken.begin(), result.broken.end(), result.above_threshold.begin(),
                      result.above_threshold.end(), std::back_inserter(hidden));
  std::ostringstream text;
  const auto tell_where = [&](const std::vector<std::int32_t>& tets) {
    const Box box = box_around(result.mesh, tets);
    text << ", within " << Shown{box.low} << " to " << Shown{box.high} << " mm";
  };
  if (!hidden.empty()) {
    text << hidden.size() << " of " << result.mesh.tets.size() << " tetrahedra keep the threshold "
         << options.material_threshold << " at their corners, but not between them";
    tell_where(hidden);
    text << ": the volume fraction jumps there, or changes within less than MinSize, now " << options.min_size
         << " mm";
  }
  if (!result.unproved.empty()) {
    text << (hidden.empty() ? "" : ". ") << result.unproved.size() << " of " << result.mesh.tets.size()
         << " tetrahedra keep the threshold " << options.material_threshold
         << " wherever it was looked at, but to prove it for all of their inside would take too long";
    tell_where(result.unproved);
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
