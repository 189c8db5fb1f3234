// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/meshing_start.hpp"

#include <algorithm>

#include "brep/told_as_separated.hpp"
#include "core/error.hpp"
#include "mesh/crossing_faces.hpp"
#include "mesh/initial.hpp"
#include "pipeline/crossing_parts.hpp"

namespace fgmesh {
namespace {

// Defaults as parts of the diagonal; MeshingOptions tells them to users.
constexpr double kSurfaceDeviation = 1.0 / 2000.0;
constexpr double kMinSize = 1.0 / 2000.0;
constexpr double kMaxSize = 1.0 / 8.0;

BrepModel read(const std::string& shape, const MeshingOptions& asked, RunControl& control) {
  asked.validate();
  control.begin_stage("reading");
  return BrepModel::from_text(shape, control);
}

/// The options with every default put in for a part of this diagonal, mm.
MeshingOptions resolved(MeshingOptions options, double diagonal) {
  const auto default_to = [&](double& length, double part) {
    if (length == 0.0) length = part * diagonal;
  };
  default_to(options.surface_deviation, kSurfaceDeviation);
  default_to(options.max_size, kMaxSize);
  if (options.min_size == 0.0) options.min_size = std::min(kMinSize * diagonal, options.max_size);
  return options;
}

/// The material of each solid that is meshed.
SolidMaterials materials_of(const std::vector<const CompositionField*>& given, const BrepModel& model,
                            const SampledBoundary& samples) {
  if (given.size() == 1) return SolidMaterials(*given.front());
  if (static_cast<int>(given.size()) != model.given_solid_count())
    throw InvalidInput("there are " + std::to_string(given.size()) + " materials for " +
                       std::to_string(model.given_solid_count()) +
                       " solids: give one for all, or one for each solid");
  std::vector<const CompositionField*> fields;
  for (int solid = 1; solid <= model.solid_count(); ++solid)
    fields.push_back(given[model.given_solid(solid) - 1]);
  return SolidMaterials(fields, samples);
}

/// What `action` returns; where it cannot be done, with the parts of the shape that are at fault.
template <class Action>
auto with_cause(const BrepModel& model, RunControl& control, const Action& action) {
  try {
    return action();
  } catch (const GeometryError& error) {
    refuse_with_cause(error.what(), model, control);
  }
}

}  // namespace

MeshingStart::MeshingStart(const std::string& shape, const std::vector<const CompositionField*>& materials,
                           const MeshingOptions& asked, RunControl& control)
    : model(read(shape, asked, control)),
      samples(with_cause(model, control, [&] { return model.sample({}, control); })),
      options(resolved(asked, samples.bounds.diagonal())),
      default_max_size(kMaxSize * samples.bounds.diagonal()),
      state(model, materials_of(materials, model, samples), options.material_threshold,
            samples.bounds.diagonal()) {
  brep::told_as_separated(!model.origins().solids.empty(),
                          [&] { require_no_crossing_faces(samples, model, control); });
}

SizingField material_sizing(const MeshingOptions& options) {
  SizingField sizing;
  sizing.constant = 0.8 * options.material_threshold;
  sizing.min_size = options.min_size;
  sizing.max_size = options.max_size;
  sizing.anisotropy = options.anisotropy;
  return sizing;
}

std::vector<Carrier> make_initial_mesh(MeshingStart& start, double size, RunControl& control) {
  start.state.chord_limit = initial_deviation(size);
  const MeshingOptions& options = start.options;
  const double narrowest = 0.9 * std::min(options.min_size, options.surface_deviation);
  std::vector<Carrier> bridged = with_cause(start.model, control, [&] {
    return make_initial_mesh(start.state, start.samples,
                             {size, start.state.chord_limit, options.min_size, narrowest}, control);
  });
  start.state.min_size = options.min_size;
  return bridged;
}

}  // namespace fgmesh
