// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/generate_mesh.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <sstream>

#include "brep/brep_model.hpp"
#include "core/error.hpp"
#include "mesh/geometry_refinement.hpp"
#include "mesh/initial.hpp"
#include "mesh/material_refinement.hpp"
#include "mesh/second_order.hpp"
#include "mesh/steiner_points.hpp"
#include "quality/curved_tets.hpp"
#include "quality/mesh_statistics.hpp"
#include "quality/validity.hpp"

namespace fgmesh {
namespace {

// Defaults as parts of the diagonal; MeshingOptions tells them to users.
constexpr double kSurfaceDeviation = 1.0 / 2000.0;
constexpr double kMinSize = 1.0 / 2000.0;
constexpr double kMaxSize = 1.0 / 8.0;

/// How far facets of the initial mesh may be from the true boundary, as part of their size.
constexpr double kInitialDeviation = 1.0 / 20.0;

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

/// Runs one stage and puts its report and its mesh into the result.
template <class Stage>
void run_stage(const char* name, const MeshState& state, MeshingResult& result, RunControl& control,
               Stage&& stage) {
  control.begin_stage(name);
  const auto start = std::chrono::steady_clock::now();
  stage();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  std::vector<int> order;
  result.mesh = state.to_tet_mesh(&order);
  result.fraction.clear();
  for (int v : order) result.fraction.push_back(state.vertices[v].value);
  if (const std::string fault = find_fault(result.mesh); !fault.empty())
    throw Error(std::string("the mesh of the stage \"") + name + "\" is not valid: " + fault);
  result.stages.push_back(make_stage_report(name, result.mesh, result.fraction, state.threshold()));
  result.stages.back().seconds = seconds.count();
}

/// Adds the nodes in the middle of edges, and the volume fraction at them.
void raise_order(const MeshState& state, MeshingResult& result, RunControl& control) {
  control.begin_stage("second order");
  result.second_order = make_second_order(result.mesh, state.boundary(), control);
  const SecondOrderMesh& mesh = result.second_order;
  std::vector<double>& fraction = result.fraction;
  fraction.resize(mesh.points.size(), std::numeric_limits<double>::quiet_NaN());
  for (const auto& tet : mesh.tets) {
    control.check();
    for (int k = 0; k < 6; ++k) {
      double& value = fraction[tet[4 + k]];
      if (!std::isnan(value)) continue;
      Vertex node;
      node.position = mesh.points[tet[4 + k]];
      const auto& [i, j] = kMiddleEdges[k];
      // Between chord and true boundary, outside the solid, f may be undefined.
      value = state.evaluate(node) ? node.value : 0.5 * (fraction[tet[i]] + fraction[tet[j]]);
    }
  }
}

/// Integral of |grad f|^3 over the mesh, by its value at the centroids.
double gradient_cubed(const TetMesh& mesh, const ScalarField& field) {
  std::vector<Vec3> centres;
  centres.reserve(mesh.tets.size());
  for (const auto& [a, b, c, d] : mesh.tets)
    centres.push_back((mesh.points[a] + mesh.points[b] + mesh.points[c] + mesh.points[d]) / 4.0);
  std::vector<double> values(centres.size());
  std::vector<Vec3> gradients(centres.size());
  field.evaluate(centres.data(), centres.size(), values.data(), gradients.data());
  double sum = 0.0;
  for (std::size_t t = 0; t < centres.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    const double slope = gradients[t].norm();
    if (std::isfinite(slope))
      sum += slope * slope * slope *
             signed_volume(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]);
  }
  return sum;
}

double largest_deviation(const MeshingResult& result, const BoundaryGeometry& boundary) {
  const TetMesh& mesh = result.mesh;
  const bool curved = !result.second_order.triangles.empty();
  double largest = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 centre = curved ? centre_of_triangle(result.second_order, i)
                               : Vec3((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0);
    const Vec3 nearest = boundary.project_to_face(mesh.triangle_faces[i], centre).position;
    largest = std::max(largest, (nearest - centre).norm());
  }
  return largest;
}

/// How many tetrahedra miss the threshold, where the worst is, and what may be done.
std::string describe_misses(const MeshingResult& result, const ScalarField& field,
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

/// How many edges could not follow the true boundary, where, and what may be done.
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

void finish(MeshingResult& result, const BrepModel& model, const ScalarField& field,
            const MeshingOptions& options) {
  result.variation = variations(result.mesh, result.fraction);
  result.dihedral_min = smallest_dihedrals(result.mesh);
  for (std::size_t t = 0; t < result.variation.size(); ++t)
    if (result.variation[t] > options.material_threshold)
      result.above_threshold.push_back(static_cast<std::int32_t>(t));
  if (!result.above_threshold.empty() && options.stop_after != "initial") {
    result.status = "threshold_not_met";
    result.messages.push_back(describe_misses(result, field, options));
  }
  const double integral = gradient_cubed(result.mesh, field);
  if (integral > 0.0)
    result.element_ratio =
        static_cast<double>(result.mesh.tets.size()) * std::pow(options.material_threshold, 3) / integral;
  result.deviation_max = largest_deviation(result, model);
  result.surface_deviation = options.surface_deviation;
  if (options.stop_after == "geometry" && result.deviation_max > options.surface_deviation) {
    if (result.status == "ok") result.status = "deviation_not_met";
    std::ostringstream text;
    text << "the boundary is up to " << result.deviation_max << " mm off its faces, where "
         << options.surface_deviation << " mm are allowed: lower MinSize, now " << options.min_size << " mm";
    result.messages.push_back(text.str());
  }
  if (!result.second_order.straightened.empty()) result.messages.push_back(describe_straightened(result));
  result.volume = result.second_order.tets.empty() ? volume(result.mesh) : volume(result.second_order);
  result.shape_volume = model.volume();
  result.peak_memory_mb = peak_memory_mb();
}

}  // namespace

MeshingResult generate_mesh(const std::string& shape, const ScalarField& material,
                            const MeshingOptions& asked, RunControl& control) {
  asked.validate();
  control.begin_stage("reading");
  BrepModel model = BrepModel::from_text(shape, control);
  if (model.solid_count() > 1)
    throw GeometryError("the shape has " + std::to_string(model.solid_count()) +
                        " solids; several at once are not available yet: mesh them one by one");
  const SampledBoundary samples = model.sample({}, control);
  const double diagonal = samples.bounds.diagonal();
  const MeshingOptions options = resolved(asked, diagonal);

  MeshingResult result;
  result.messages = model.notes();
  MeshState state(model, material, options.material_threshold, diagonal);
  state.chord_limit = kInitialDeviation * options.max_size;
  run_stage("initial", state, result, control, [&] {
    make_initial_mesh(state, samples, {options.max_size, state.chord_limit}, control);
  });
  if (options.stop_after != "initial") {
    run_stage("material", state, result, control, [&] {
      MaterialRefinementOptions refinement;
      refinement.sizing = {0.8 * options.material_threshold, options.min_size, options.max_size, 0.5};
      refine_material(state, refinement, control);
    });
  }
  if (options.stop_after == "geometry") {
    run_stage("geometry", state, result, control, [&] {
      GeometryRefinementOptions refinement;
      refinement.deviation = options.surface_deviation;
      refinement.min_size = options.min_size;
      refine_geometry(state, refinement, control);
    });
  }
  if (options.order == 2) raise_order(state, result, control);
  finish(result, model, material, options);
  return result;
}

}  // namespace fgmesh
