// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include <algorithm>
#include <functional>

#include "reference_checks.hpp"

namespace fgmesh {
namespace {

using test::random_points;

using Distance = std::function<double(const Vec3&)>;

/// Tetrahedra of edges up to about `size` at random places, and random corners.
std::vector<Corners> random_tets(int count, double reach, double size) {
  const std::vector<Vec3> places = random_points(count, reach), ways = random_points(4 * count, 0.5 * size);
  std::vector<Corners> tets(count);
  for (int t = 0; t < count; ++t)
    for (int i = 0; i < 4; ++i) tets[t][i] = places[t] + ways[4 * t + i];
  return tets;
}

/// The least and the largest value on a grid of points of the tetrahedron.
std::pair<double, double> sampled_range(const Corners& tet, const Distance& distance) {
  constexpr int kSteps = 8;
  std::pair<double, double> range{1e300, -1e300};
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; i + j <= kSteps; ++j) {
      for (int k = 0; i + j + k <= kSteps; ++k) {
        const int l = kSteps - i - j - k;
        const double value = distance((i * tet[0] + j * tet[1] + k * tet[2] + l * tet[3]) / kSteps);
        range = {std::min(range.first, value), std::max(range.second, value)};
      }
    }
  }
  return range;
}

struct Measured {
  const char* name;
  TopoDS_Shape shape;
  std::string part;
  Distance distance;
};

/// Parts whose distance has a closed form.
std::vector<Measured> measured_parts() {
  const Vec3 high(10, 20, 30);
  const auto to_box = [=](const Vec3& p) {
    const double depth = std::min(p.minCoeff(), (high - p).minCoeff());
    return depth > 0.0 ? -depth : (p - p.cwiseMax(Vec3::Zero()).cwiseMin(high)).norm();
  };
  const auto to_face = [=](const Vec3& p) {
    return (p - p.cwiseMax(Vec3::Zero()).cwiseMin(Vec3(0, 20, 30))).norm();
  };
  const auto to_mantle = [](const Vec3& p) {
    return std::hypot(test::meridian(p)[0] - 10.0, std::max({-p.z(), p.z() - 20.0, 0.0}));
  };
  return {{"solid", test::box(10, 20, 30), "Solid1", to_box},
          {"plane", test::box(10, 20, 30), "Face1", to_face},
          {"vertex", test::box(10, 20, 30), "Vertex1", {}},
          {"mantle", BRepPrimAPI_MakeCylinder(10.0, 20.0).Shape(), "Face1", to_mantle}};
}

class TetDistances : public ::testing::TestWithParam<double> {};

TEST_P(TetDistances, HoldWhatIsInTheTetrahedron) {
  for (Measured& part : measured_parts()) {
    SCOPED_TRACE(part.name);
    const Reference reference = test::reference(part.shape, part.part);
    if (!part.distance) {
      // Which corner of the box it is does not matter: that at distance 0.
      Vec3 corner;
      for (int i = 0; i < 8; ++i) {
        const Vec3 at(i & 1 ? 10 : 0, i & 2 ? 20 : 0, i & 4 ? 30 : 0);
        if (test::value_at(reference, at) == 0.0) corner = at;
      }
      part.distance = [=](const Vec3& p) { return (p - corner).norm(); };
    }
    for (const Corners& tet : random_tets(400, 35.0, GetParam())) {
      double low = 0.0, high = 0.0;
      reference.distance->tet_bounds(tet, low, high);
      const auto [least, most] = sampled_range(tet, part.distance);
      ASSERT_LE(low, least + test::kExact) << Shown{tet[0]};
      ASSERT_GE(high, most - test::kExact) << Shown{tet[0]};
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfSize, TetDistances, ::testing::Values(0.1, 1.0, 5.0, 40.0));

TEST(TetDistances, AreOfSecondOrderClearOfTheReference) {
  const Reference reference = test::reference(BRepPrimAPI_MakeCylinder(10.0, 20.0).Shape(), "Face1");
  const auto distance = [&](const Vec3& p) { return test::value_at(reference, p); };
  const auto excess = [&](double size) {
    double sum = 0.0;
    for (Corners tet : random_tets(200, 3.0, size)) {
      for (Vec3& corner : tet) corner += Vec3(20, 0, 10);  // outside, beside the mantle
      double low = 0.0, high = 0.0;
      reference.distance->tet_bounds(tet, low, high);
      const auto [least, most] = sampled_range(tet, distance);
      sum += (high - low) - (most - least);
    }
    return sum;
  };
  EXPECT_LT(excess(1.0), excess(2.0) / 3.0);
  EXPECT_LT(excess(0.5), excess(1.0) / 3.0);
}

}  // namespace
}  // namespace fgmesh
