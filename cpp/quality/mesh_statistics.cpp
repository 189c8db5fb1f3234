// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/mesh_statistics.hpp"

#include <limits>
#include <numeric>

#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

void count(Histogram& histogram, double value) {
  const double place = (value - histogram.low) / (histogram.high - histogram.low) * histogram.counts.size();
  const double last = static_cast<double>(histogram.counts.size() - 1);
  ++histogram.counts[static_cast<std::size_t>(std::clamp(place, 0.0, last))];
}

Histogram empty_histogram(double low, double high, std::size_t bins) {
  return {low, high, std::vector<std::size_t>(bins, 0)};
}

}  // namespace

std::vector<double> smallest_dihedrals(const TetMesh& mesh) {
  std::vector<double> result;
  result.reserve(mesh.tets.size());
  for (const auto& [a, b, c, d] : mesh.tets)
    result.push_back(dihedral_range(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]).smallest);
  return result;
}

std::vector<double> tet_volumes(const TetMesh& mesh) {
  std::vector<double> result;
  result.reserve(mesh.tets.size());
  for (const auto& [a, b, c, d] : mesh.tets)
    result.push_back(signed_volume(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d]));
  return result;
}

double volume(const TetMesh& mesh) {
  const std::vector<double> volumes = tet_volumes(mesh);
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

StageReport make_stage_report(const std::string& name, const TetMesh& mesh,
                              const std::vector<double>& variation, double threshold) {
  StageReport report;
  report.name = name;
  report.points = mesh.points.size();
  report.facets = mesh.triangles.size();
  report.tets = mesh.tets.size();
  report.variation_histogram = empty_histogram(0.0, 2.0 * threshold, 40);
  report.dihedral_histogram = empty_histogram(0.0, 180.0, 36);
  if (mesh.tets.empty()) return report;

  const auto [low, high] = std::minmax_element(variation.begin(), variation.end());
  report.variation_min = *low;
  report.variation_max = *high;
  report.variation_mean = std::accumulate(variation.begin(), variation.end(), 0.0) / variation.size();
  for (const double value : variation) {
    report.above_threshold += value > threshold;
    count(report.variation_histogram, value);
  }
  double least_cosine = 1.0, largest_cosine = -1.0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    for (const double cosine :
         dihedral_cosines(mesh.points[a], mesh.points[b], mesh.points[c], mesh.points[d])) {
      least_cosine = std::min(least_cosine, cosine);
      largest_cosine = std::max(largest_cosine, cosine);
      count(report.dihedral_histogram, angle_of(cosine));
    }
  }
  report.dihedral_min = angle_of(largest_cosine);
  report.dihedral_max = angle_of(least_cosine);
  return report;
}

}  // namespace fgmesh
