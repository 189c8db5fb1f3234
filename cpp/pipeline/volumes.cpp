// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/volumes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "core/error.hpp"
#include "pipeline/given_numbers.hpp"
#include "quality/curved_tets.hpp"
#include "quality/mesh_statistics.hpp"

namespace fgmesh {
namespace {

std::vector<double> curved_volumes(const MeshingResult& result) {
  return result.second_order.tets.empty() ? tet_volumes(result.mesh) : tet_volumes(result.second_order);
}

/// Of SolidN at n - 1, from those of the tetrahedra.
std::vector<double> solid_volumes(const TetMesh& mesh, const std::vector<double>& tets,
                                  const BrepModel& model) {
  std::vector<double> sums(model.solid_count(), 0.0);
  for (std::size_t t = 0; t < tets.size(); ++t) sums[mesh.tet_solids[t] - 1] += tets[t];
  return sums;
}

void tell_volume_errors(MeshingResult& result) {
  for (std::size_t i = 0; i < result.solid_volumes.size(); ++i) {
    const double exact = result.shape_solid_volumes[i], error = result.solid_volumes[i] - exact;
    if (!(std::abs(error) > kVolumeGoal * exact)) continue;
    std::ostringstream text;
    text.precision(2);
    text << "Solid" << i + 1 << " has " << 100.0 * std::abs(error) / exact << " % "
         << (error < 0.0 ? "less" : "more")
         << " volume in the mesh than in the shape: lower SurfaceDeviation, now " << result.surface_deviation
         << " mm";
    result.messages.push_back(text.str());
  }
}

}  // namespace

double lowered_deviation(double deviation, double error, double diagonal) {
  constexpr double kAim = 0.8, kSmallestStep = 0.8;
  return std::max(least_deviation(diagonal), deviation * std::min(kSmallestStep, kAim * kVolumeGoal / error));
}

double largest_volume_error(const TetMesh& mesh, const BrepModel& model) {
  const std::vector<double> volumes = solid_volumes(mesh, tet_volumes(mesh), model);
  double largest = 0.0;
  for (std::size_t i = 0; i < volumes.size(); ++i)
    largest = std::max(largest, std::abs(volumes[i] / model.volumes()[i] - 1.0));
  return largest;
}

std::vector<double> facet_deviations(const MeshingResult& result, const BoundaryGeometry& boundary) {
  const TetMesh& mesh = result.mesh;
  const bool curved = !result.second_order.triangles.empty();
  std::vector<double> deviations(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 centre = curved ? centre_of_triangle(result.second_order, i)
                               : Vec3((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0);
    deviations[i] = (boundary.project_to_face(mesh.triangle_faces[i], centre).position - centre).norm();
  }
  return deviations;
}

void require_explained_volumes(const MeshingResult& result, const std::vector<double>& deviations,
                               const BrepModel& model) {
  // Over a facet whose face bends evenly the mean distance is 3/4 of that at the centre. At edges of the
  // shape it bends otherwise.
  constexpr double kMeanDeviation = 3.0, kRounding = 1e-3;
  const TetMesh& mesh = result.mesh;
  double explained = kRounding * model.volume();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const double twice_area = (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
    explained += kMeanDeviation * deviations[i] * 0.5 * twice_area;
  }
  const std::vector<double> volumes = solid_volumes(mesh, curved_volumes(result), model);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const double exact = model.volumes()[i], error = std::abs(volumes[i] - exact);
    if (error <= explained) continue;
    std::ostringstream text;
    text.precision(3);
    text << "a part of " << given_name({3, static_cast<std::int32_t>(i + 1)}, model.origins())
         << " was lost: its volume in the mesh is " << volumes[i] << " mm^3 where the shape has " << exact
         << "; lower MaxSize";
    throw GeometryError(text.str());
  }
}

void put_volumes(const BrepModel& model, MeshingResult& result) {
  const std::vector<double> volumes = solid_volumes(result.mesh, curved_volumes(result), model);
  result.solid_volumes.assign(model.given_solid_count(), 0.0);
  result.shape_solid_volumes.assign(model.given_solid_count(), 0.0);
  for (int solid = 1; solid <= model.solid_count(); ++solid) {
    result.solid_volumes[model.given_solid(solid) - 1] += volumes[solid - 1];
    result.shape_solid_volumes[model.given_solid(solid) - 1] += model.volumes()[solid - 1];
  }
  result.volume = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  result.shape_volume = model.volume();
  tell_volume_errors(result);
}

}  // namespace fgmesh
