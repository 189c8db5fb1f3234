// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/generate_mesh.hpp"

#include <algorithm>
#include <chrono>
#include <sstream>

#include "brep/brep_model.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "mesh/certification.hpp"
#include "mesh/geometry_refinement.hpp"
#include "mesh/material_refinement.hpp"
#include "mesh/second_order.hpp"
#include "pipeline/crossing_parts.hpp"
#include "pipeline/estimate.hpp"
#include "pipeline/given_numbers.hpp"
#include "pipeline/meshing_start.hpp"
#include "pipeline/node_fractions.hpp"
#include "pipeline/unmet_criteria.hpp"
#include "pipeline/volumes.hpp"
#include "quality/mesh_statistics.hpp"
#include "quality/same_boundary.hpp"
#include "quality/small_angles.hpp"
#include "quality/validity.hpp"

namespace fgmesh {
namespace {

/// The fractions at the corners of the tetrahedra, and what follows from them.
void put_fractions(const NodeFractions& fractions, double threshold, MeshingResult& result) {
  result.constituents = fractions.columns();
  result.fractions = fractions.at_points();
  result.variation = fractions.variations(result.mesh.tets);
  result.above_threshold.clear();
  for (std::size_t t = 0; t < result.variation.size(); ++t)
    if (result.variation[t] > threshold) result.above_threshold.push_back(static_cast<std::int32_t>(t));
}

/// Runs one stage and puts its report and its mesh into the result.
template <class Stage>
NodeFractions run_stage(const char* name, const MeshState& state, MeshingResult& result, RunControl& control,
                        Stage&& stage) {
  control.begin_stage(name);
  const auto start = std::chrono::steady_clock::now();
  stage();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  std::vector<int> order;
  result.mesh = state.to_tet_mesh(&order);
  if (const std::string fault = find_fault(result.mesh); !fault.empty())
    throw Error(std::string("the mesh of the stage \"") + name + "\" is not valid: " + fault);
  NodeFractions fractions(state, result.mesh, order);
  put_fractions(fractions, state.threshold(), result);
  result.stages.push_back(make_stage_report(name, result.mesh, result.variation, state.threshold()));
  result.stages.back().seconds = seconds.count();
  return fractions;
}

/// Certifies the threshold, as part of the last stage, and puts what came of it into the result.
void certify(MeshState& state, const QualityGoal& goal, const MeshingOptions& options, MeshingResult& result,
             RunControl& control) {
  if (!options.certify) return;
  control.begin_stage("certificate");
  const auto start = std::chrono::steady_clock::now();
  const std::vector<TetCertificate> certificates = certify_mesh(state, goal, control);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  result.certificate = {};
  result.certificate.made = true;
  result.certificate.seconds = seconds.count();
  for (int t = 0; t < state.complex.slots(); ++t) {
    if (!state.complex.tet(t).alive()) continue;
    // Finished meshes have the tetrahedra in the order of their slots.
    const auto index = static_cast<std::int32_t>(result.certificate.tets++);
    const TetCertificate& found = certificates[t];
    if (found.proof == Proof::kProved)
      result.certificate.bound = std::max(result.certificate.bound, found.bound);
    else
      (found.proof == Proof::kBroken ? result.broken : result.unproved).push_back(index);
  }
  result.certificate.broken = result.broken.size();
  result.certificate.unproved = result.unproved.size();
}

/// Adds the nodes in the middle of edges, and the volume fraction at them.
void raise_order(const MeshState& state, NodeFractions& fractions, MeshingResult& result,
                 RunControl& control) {
  control.begin_stage("second order");
  result.second_order = make_second_order(result.mesh, state.boundary(), control);
  fractions.add_middle_nodes(state, result.second_order, control);
  result.fractions = fractions.at_points();
}

/// Integral of |grad f|^3 over the mesh, by its value at the centroids.
double gradient_cubed(const TetMesh& mesh, const SolidMaterials& materials) {
  const std::vector<double> volumes = tet_volumes(mesh);
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    const Vec3 centre = (mesh.points[a] + mesh.points[b] + mesh.points[c] + mesh.points[d]) / 4.0;
    const CompositionField& field = materials.field(materials.of_solid(mesh.tet_solids[t]));
    Composition fractions(field.constituents() - 1);
    CompositionGradient gradient(fractions.size());
    field.evaluate(&centre, 1, fractions.data(), gradient.data());
    const bool finite =
        std::all_of(gradient.begin(), gradient.end(), [](const Vec3& part) { return part.allFinite(); });
    const double slope = finite ? steepest(gradient).norm() : 0.0;
    sum += slope * slope * slope * volumes[t];
  }
  return sum;
}

/// Which parts of the shape have no elements since they were bridged, and what may be done.
std::string describe_bridged(const TetMesh& mesh, std::vector<Carrier> bridged, const MeshingOptions& options,
                             const PartName& name) {
  constexpr int kMostNames = 6;
  std::sort(bridged.begin(), bridged.end(), [](const Carrier& a, const Carrier& b) {
    return std::pair(-a.dimension, a.number) < std::pair(-b.dimension, b.number);
  });
  std::string names;
  int count = 0;
  for (const Carrier& part : bridged) {
    const auto is_part = [&](const Carrier& carrier) {
      return carrier.dimension == part.dimension && carrier.number == part.number;
    };
    const auto has = [&](const std::vector<std::int32_t>& numbers) {
      return std::find(numbers.begin(), numbers.end(), part.number) != numbers.end();
    };
    if (part.dimension == 0   ? std::any_of(mesh.carriers.begin(), mesh.carriers.end(), is_part)
        : part.dimension == 1 ? has(mesh.edge_edges)
                              : has(mesh.triangle_faces))
      continue;
    if (++count <= kMostNames) names += (count > 1 ? ", " : "") + name(part);
  }
  if (count == 0) return {};
  std::ostringstream text;
  text << names << (count > kMostNames ? " and others" : "") << (count > 1 ? " are" : " is")
       << " smaller than MinSize, now " << options.min_size << " mm, and bridged: no element is there";
  return text.str();
}

void finish(MeshingResult& result, const BrepModel& model, const SampledBoundary& samples,
            const std::vector<Carrier>& bridged, const SolidMaterials& materials,
            const MeshingOptions& options, RunControl& control) {
  const auto name = [&](const Carrier& part) { return given_name(part, model.origins()); };
  if (const std::string lost = find_difference(result.mesh, samples, bridged, name); !lost.empty())
    refuse_with_cause("the mesh is not the shape: " + lost + "; lower MaxSize", model, control);
  if (const std::string told = describe_bridged(result.mesh, bridged, options, name); !told.empty())
    result.messages.push_back(told);
  result.dihedral_min = smallest_dihedrals(result.mesh);
  if (!result.above_threshold.empty() && options.stop_after != "initial") {
    result.status = "threshold_not_met";
    const auto worst = std::max_element(result.variation.begin(), result.variation.end());
    const int solid = result.mesh.tet_solids[worst - result.variation.begin()];
    result.messages.push_back(describe_misses(result, materials.field(materials.of_solid(solid)), options));
  }
  if (!result.broken.empty()) result.status = "threshold_not_met";
  if (const std::string told = describe_certificate(result, options); !told.empty())
    result.messages.push_back(told);
  const double integral = gradient_cubed(result.mesh, materials);
  if (integral > 0.0)
    result.element_ratio =
        static_cast<double>(result.mesh.tets.size()) * std::pow(options.material_threshold, 3) / integral;
  const std::vector<double> deviations = facet_deviations(result, model);
  require_explained_volumes(result, deviations, model);
  result.deviation_max = *std::max_element(deviations.begin(), deviations.end());
  result.surface_deviation = options.surface_deviation;
  if (options.stop_after == "geometry" && result.deviation_max > options.surface_deviation) {
    if (result.status == "ok") result.status = "deviation_not_met";
    std::ostringstream text;
    text << "the boundary is up to " << result.deviation_max << " mm off its faces, where "
         << options.surface_deviation << " mm are allowed: lower MinSize, now " << options.min_size << " mm";
    result.messages.push_back(text.str());
  }
  SmallAngles angles = find_small_angles(result.mesh, result.dihedral_min, model, options.min_size, name);
  for (std::string& message : describe(angles, result.mesh, result.dihedral_min))
    result.messages.push_back(std::move(message));
  result.angle_goal = kAngleGoal;
  result.forced_angles = std::move(angles.forced);
  result.small_angles = std::move(angles.unforced);
  if (!result.second_order.straightened.empty()) result.messages.push_back(describe_straightened(result));
  result.peak_memory_mb = peak_memory_mb();
}

/// Lowers the deviation until the volumes are right, as the default is to. Returns it; or that which was
/// given, where MinSize is in the way of so small a deviation.
double refine_to_volume(MeshState& state, GeometryRefinementOptions refinement, const BrepModel& model,
                        RunControl& control) {
  const double given = refinement.deviation;
  while (refinement.deviation > least_deviation(state.diagonal())) {
    const double error = largest_volume_error(state.to_tet_mesh(), model);
    if (error <= kVolumeGoal) break;
    refinement.deviation = lowered_deviation(refinement.deviation, error, state.diagonal());
    refine_geometry(state, refinement, control);
  }
  const TetComplex& complex = state.complex;
  for (int t = 0; t < complex.slots(); ++t)
    for (int face = 0; face < 4 && complex.tet(t).alive(); ++face)
      if (complex.tet(t).label[face] && facet_deviation(state, t, face) > refinement.deviation) return given;
  return refinement.deviation;
}

/// Tells beforehand how large the mesh will be, unless that took long.
void tell_expected(const MeshingStart& start, const MeshingOptions& asked, RunControl& control) {
  constexpr int kQuick = 20000;  // tetrahedra that are quickly summed up
  if (start.state.complex.tet_count() > kQuick) return;
  control.expect(static_cast<std::size_t>(expected_tets(start, asked, start.options.max_size, control)));
}

MeshingResult run(const std::string& shape, const std::vector<const CompositionField*>& given,
                  const MeshingOptions& asked, RunControl& control) {
  MeshingStart start(shape, given, asked, control);
  BrepModel& model = start.model;
  MeshState& state = start.state;
  MeshingOptions options = start.options;

  MeshingResult result;
  result.messages = model.notes();
  std::vector<Carrier> bridged;
  NodeFractions fractions = run_stage("initial", state, result, control,
                                      [&] { bridged = make_initial_mesh(start, options.max_size, control); });
  QualityGoal goal = quality_goal(options.anisotropy);
  goal.between = options.certify;
  if (asked.max_size > 0.0) goal.longest_edge = asked.max_size;
  if (options.stop_after != "initial") {
    tell_expected(start, asked, control);
    fractions = run_stage("material", state, result, control, [&] {
      MaterialRefinementOptions refinement;
      refinement.sizing = material_sizing(options);
      refinement.goal = goal;
      refinement.points_only = options.paper;
      refine_material(state, refinement, control);
      for (Vertex& vertex : state.vertices) vertex.frozen = options.paper;
      state.keeps_frozen = options.paper;
      if (options.stop_after == "material") certify(state, goal, options, result, control);
    });
  }
  if (options.stop_after == "geometry") {
    fractions = run_stage("geometry", state, result, control, [&] {
      GeometryRefinementOptions refinement;
      refinement.deviation = options.surface_deviation;
      refinement.goal = goal;
      refine_geometry(state, refinement, control);
      if (asked.surface_deviation == 0.0)
        options.surface_deviation = refine_to_volume(state, refinement, model, control);
      certify(state, goal, options, result, control);
    });
  }
  if (options.order == 2) raise_order(state, fractions, result, control);
  if (state.materials().count() > 1)
    result.tet_fractions = options.order == 2 ? fractions.at_tets(result.second_order.tets)
                                              : fractions.at_tets(result.mesh.tets);
  finish(result, model, start.samples, bridged, state.materials(), options, control);
  put_volumes(model, result);
  use_given_numbers(result, model.origins());
  result.threads = threads_in_use();
  return result;
}

}  // namespace

MeshingResult generate_mesh(const std::string& shape, const std::vector<const CompositionField*>& materials,
                            const MeshingOptions& options, RunControl& control) {
  MeshingResult result;
  with_threads(options.threads, [&] { result = run(shape, materials, options, control); });
  return result;
}

}  // namespace fgmesh
