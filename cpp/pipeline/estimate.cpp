// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/boundary_sizes.hpp"
#include "pipeline/expected_tets.hpp"
#include "pipeline/meshing_start.hpp"

namespace fgmesh {
namespace {

/// The size of the elements of the initial mesh to make: that of the mesh asked for, unless this would have
/// so many that the estimate took long.
double size_to_make(const MeshingStart& start) {
  constexpr double kMany = 8000.0;
  constexpr double kAlike = 0.8;  // then the initial mesh itself tells more than what one foretells
  const double asked = start.options.max_size;
  const double coarse =
      std::min(start.default_max_size, std::cbrt(kInitialTets * start.model.volume() / kMany));
  return asked > kAlike * coarse ? asked : coarse;
}

/// Fitted to the child processes of some 110 meshes of 200 to 217000 tetrahedra, and within 20 % of nearly
/// all: the libraries, the text and what OpenCASCADE makes of it, samples, tetrahedra.
double memory_mb(const std::string& shape, const SampledBoundary& samples, double tets, int order) {
  constexpr double kAlone = 60e6, kByte = 25.0, kSample = 650.0, kTet = 260.0, kSecondOrder = 220.0;
  return (kAlone + kByte * shape.size() + kSample * samples.triangles.size() +
          (order == 2 ? kTet + kSecondOrder : kTet) * tets) /
         1e6;
}

}  // namespace

double expected_tets(const MeshingStart& start, const MeshingOptions& asked, double size,
                     RunControl& control) {
  const MeshingOptions& options = start.options;
  const BentBoundary boundary(start.state, start.model, control);
  WantedMesh wanted;
  wanted.material = options.stop_after != "initial";
  wanted.threshold = options.material_threshold;
  wanted.sizing = material_sizing(options);
  if (size > options.max_size) {
    wanted.max_size = options.max_size;
    wanted.initial = boundary.initial_sizes(options.max_size, options.min_size);
  }
  if (options.stop_after == "geometry") {
    const double deviation = options.surface_deviation;
    wanted.deviation = boundary.deviation_sizes(
        asked.surface_deviation == 0.0 ? boundary.lowered(deviation) : deviation, options.min_size);
  }
  return expected_tets(start.state, wanted, control);
}

MeshEstimate estimate_mesh(const std::string& shape, const std::vector<const CompositionField*>& materials,
                           const MeshingOptions& asked, RunControl& control) {
  MeshingStart start(shape, materials, asked, control);
  control.begin_stage("initial");
  const double size = size_to_make(start);
  make_initial_mesh(start, size, control);

  control.begin_stage("estimate");
  MeshEstimate result;
  result.tets = expected_tets(start, asked, size, control);
  result.memory_mb = memory_mb(shape, start.samples, result.tets, start.options.order);
  return result;
}

}  // namespace fgmesh
