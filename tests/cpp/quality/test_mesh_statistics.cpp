// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include "box_grid.hpp"
#include "quality/mesh_statistics.hpp"

namespace fgmesh {
namespace {

std::size_t sum(const Histogram& histogram) {
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::size_t{0});
}

/// Tetrahedra side by side on separate points.
TetMesh separate_tets(std::size_t count) {
  TetMesh mesh;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 start(2.0 * t, 0, 0);
    const auto first = static_cast<std::int32_t>(mesh.points.size());
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
      mesh.points.push_back(start + p);
    mesh.tets.push_back({first, first + 1, first + 2, first + 3});
  }
  return mesh;
}

TEST(MeshStatistics, OfAGridWithALinearFraction) {
  constexpr int kCells = 4;
  const TetMesh mesh = test::box_grid(3.0, kCells);
  EXPECT_NEAR(volume(mesh), 27.0, 1e-12);
  // Every one of the tetrahedra reaches across its cell.
  const std::vector<double> variation(mesh.tets.size(), 0.25);
  for (const double angle : smallest_dihedrals(mesh)) EXPECT_NEAR(angle, 45.0, 1e-10);

  const StageReport report = make_stage_report("initial", mesh, variation, 0.1);
  EXPECT_EQ(report.name, "initial");
  EXPECT_EQ(report.points, 125u);
  EXPECT_EQ(report.tets, 6u * 64u);
  EXPECT_EQ(report.facets, 2u * 6u * 16u);
  EXPECT_NEAR(report.variation_min, 0.25, 1e-14);
  EXPECT_NEAR(report.variation_max, 0.25, 1e-14);
  EXPECT_NEAR(report.variation_mean, 0.25, 1e-14);
  EXPECT_EQ(report.above_threshold, report.tets);
  EXPECT_NEAR(report.dihedral_min, 45.0, 1e-10);
  EXPECT_NEAR(report.dihedral_max, 90.0, 1e-10);
}

TEST(MeshStatistics, CountsSumUp) {
  const TetMesh mesh = test::box_grid(1.0, 3);
  std::vector<double> variation;
  for (const Vec3& p : mesh.points) variation.push_back(p.squaredNorm() / 3.0);
  variation.resize(mesh.tets.size());
  const StageReport report = make_stage_report("initial", mesh, variation, 0.05);
  EXPECT_EQ(sum(report.variation_histogram), mesh.tets.size());
  EXPECT_EQ(sum(report.dihedral_histogram), 6 * mesh.tets.size());
  EXPECT_GT(report.variation_max, 2.0 * 0.05) << "some must fall beyond the bins for this to be a test";
}

TEST(MeshStatistics, PutsVariationsIntoTheirBins) {
  const std::vector<double> variation = {0.0, 0.2501, 0.5, 0.7501, 1.0};
  const TetMesh mesh = separate_tets(variation.size());
  const StageReport report = make_stage_report("material", mesh, variation, 0.25);
  EXPECT_EQ(report.variation_histogram.low, 0.0);
  EXPECT_DOUBLE_EQ(report.variation_histogram.high, 0.5);
  const std::vector<std::size_t>& counts = report.variation_histogram.counts;
  ASSERT_GE(counts.size(), 4u);
  ASSERT_EQ(counts.size() % 2, 0u) << "the threshold lies between two bins";
  EXPECT_EQ(counts.front(), 1u);
  EXPECT_EQ(counts[counts.size() / 2], 1u);
  EXPECT_EQ(counts.back(), 3u) << "the upper end and what is beyond";
  EXPECT_DOUBLE_EQ(report.variation_mean, (0.2501 + 0.5 + 0.7501 + 1.0) / 5.0);
  EXPECT_EQ(report.variation_min, 0.0);
  EXPECT_EQ(report.variation_max, 1.0);
}

TEST(MeshStatistics, WhatIsExactlyAtTheThresholdIsNotAbove) {
  const std::vector<double> variation = {0.125, 0.125 + 1e-12, 0.1};
  EXPECT_EQ(make_stage_report("material", separate_tets(3), variation, 0.125).above_threshold, 1u);
}

TEST(MeshStatistics, PutsAnglesIntoTheirBins) {
  // Of the six angles of a corner of a cube three are right, three 54.7 degrees.
  const Histogram histogram =
      make_stage_report("initial", separate_tets(2), {0.5, 0.5}, 0.1).dihedral_histogram;
  EXPECT_EQ(histogram.low, 0.0);
  EXPECT_EQ(histogram.high, 180.0);
  const double width = 180.0 / static_cast<double>(histogram.counts.size());
  std::size_t near_right = 0;
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) {
    const double low = static_cast<double>(bin) * width;
    if (low <= 54.7 && 54.7 < low + width) {
      EXPECT_EQ(histogram.counts[bin], 6u);
    }
    // Rounding may put a right angle on either side of 90.
    if (low + width >= 90.0 && low <= 90.0) near_right += histogram.counts[bin];
  }
  EXPECT_EQ(near_right, 6u);
}

TEST(MeshStatistics, OfNothing) {
  const StageReport report = make_stage_report("initial", {}, {}, 0.1);
  EXPECT_EQ(report.tets, 0u);
  EXPECT_EQ(sum(report.variation_histogram), 0u);
  EXPECT_EQ(volume({}), 0.0);
}

}  // namespace
}  // namespace fgmesh
