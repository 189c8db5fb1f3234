// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/initial.hpp"
#include "mesh/material_refinement.hpp"
#include "mesh_checks.hpp"

namespace fgmesh::test {

/// A solid taken through the stages as the pipeline does, with lengths in proportion to it.
struct RefinedPart {
  RefinedPart(const AnalyticSolid& part, const CompositionField& material, double threshold)
      : solid(part),
        samples(part.samples()),
        diagonal(samples.bounds.diagonal()),
        state(part, material, threshold, diagonal) {
    state.chord_limit = max_size() / 20.0;
    make_initial_mesh(state, samples, {max_size(), state.chord_limit}, control);
    state.min_size = min_size();
  }
  RefinedPart(const RefinedPart&) = delete;

  double max_size() const { return diagonal / 8.0; }
  double min_size() const { return diagonal / 2000.0; }

  void refine(double anisotropy = 1.0) {
    MaterialRefinementOptions options;
    options.sizing = {0.8 * state.threshold(), min_size(), max_size(), 0.5, anisotropy};
    options.goal = quality_goal(anisotropy);
    refine_material(state, options, control);
  }

  const AnalyticSolid& solid;
  const SampledBoundary samples;
  const double diagonal;
  MeshState state;
  RunControl control;
};

}  // namespace fgmesh::test
