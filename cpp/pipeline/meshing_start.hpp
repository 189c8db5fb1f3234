// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brep/brep_model.hpp"
#include "core/run_control.hpp"
#include "domain/sizing_field.hpp"
#include "mesh/mesh_state.hpp"
#include "pipeline/meshing_options.hpp"

namespace fgmesh {

/// What a mesh and the estimate of one begin with: the shape read, checked and sampled, the options with
/// every default put in, and a mesh in progress that is empty yet.
struct MeshingStart {
  /// Arguments and errors are those of generate_mesh().
  MeshingStart(const std::string& shape, const std::vector<const CompositionField*>& materials,
               const MeshingOptions& asked, RunControl& control);
  MeshingStart(const MeshingStart&) = delete;  // `state` knows `model` by its address

  BrepModel model;
  SampledBoundary samples;
  MeshingOptions options;
  double default_max_size;  ///< mm
  MeshState state;
};

/// How far facets of an initial mesh of elements of `size` may be from the true boundary, mm.
inline double initial_deviation(double size) { return size / 20.0; }

/// The sizes that the material-oriented refinement is to give elements, for options without defaults.
SizingField material_sizing(const MeshingOptions& options);

/// Fills start.state with the initial mesh, of elements of start.options.max_size or of another `size`, mm.
/// Returns the parts of the shape that may have been bridged.
std::vector<Carrier> make_initial_mesh(MeshingStart& start, double size, RunControl& control);

}  // namespace fgmesh
