// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <type_traits>

#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

TEST(Material, KeepsWhatItWasMadeOf) {
  const Material material({"alpha*z"}, {{"alpha", 0.5}}, rotated_frame());
  EXPECT_EQ(material.fractions(), std::vector<std::string>{"alpha*z"});
  EXPECT_EQ(material.parameters().at("alpha"), 0.5);
  EXPECT_EQ(material.frame().origin, rotated_frame().origin);
  EXPECT_EQ(material.frame().rotation, rotated_frame().rotation);
  static_assert(!std::is_copy_constructible_v<Material> && std::is_move_constructible_v<Material>);
}

TEST(Material, GivesTheSameInBatchesOfEverySize) {
  std::mt19937 random(23);
  std::vector<Vec3> points(1000);
  for (Vec3& p : points) p = random_point(random, 5.0);
  for (const std::string& formula : sample_formulas()) {
    const Material material({formula}, {}, rotated_frame());
    std::vector<double> values(points.size()), again(points.size());
    std::vector<Vec3> gradients(points.size());
    material.evaluate(points.data(), points.size(), values.data(), gradients.data());
    for (const std::size_t size : {1u, 127u, 128u, 129u, 1000u}) {
      for (std::size_t i = 0; i < points.size(); i += size) {
        material.evaluate(&points[i], std::min<std::size_t>(size, points.size() - i), &again[i]);
      }
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_TRUE(values[i] == again[i] || (std::isnan(values[i]) && std::isnan(again[i]))) << formula;
      }
    }
  }
}

TEST(Material, OfThreeConstituentsGivesTheFractionsOfTwo) {
  const Material material({"a*x", "y^2/9"}, {{"a", 0.1}});
  EXPECT_EQ(material.constituents(), 3);
  const std::vector<Vec3> points = {Vec3(1, 2, 3), Vec3(4, 1, 0)};
  std::vector<double> fractions(4), again(4);
  std::vector<Vec3> gradients(4);
  material.evaluate(points.data(), 2, fractions.data());
  material.evaluate(points.data(), 2, again.data(), gradients.data());
  const std::vector<double> expected = {0.1, 0.4, 4.0 / 9.0, 1.0 / 9.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(fractions[i], expected[i], 1e-15);
  EXPECT_EQ(fractions, again);
  EXPECT_LT((gradients[1] - Vec3(0.1, 0, 0)).norm() + (gradients[2] - Vec3(0, 4.0 / 9.0, 0)).norm(), 1e-14);
  double low[2], high[2];
  material.bounds({Vec3(1, 1, 0), Vec3(2, 3, 0)}, low, high);
  EXPECT_NEAR(low[0] + low[1], 0.1 + 1.0 / 9.0, 1e-12);
  EXPECT_NEAR(high[0] + high[1], 0.2 + 1.0, 1e-12);
}

TEST(Material, EvaluatesNoPointsAndConstants) {
  const Material material({"2^0.5 + 1"});
  material.evaluate(nullptr, 0, nullptr);
  material.evaluate(nullptr, 0, nullptr, nullptr);
  EXPECT_DOUBLE_EQ(value_at(material, Vec3::Zero()), 2.414213562373095);
  EXPECT_EQ(gradient_at(material, Vec3::Zero()), Vec3(0, 0, 0));
}

TEST(Material, PassesNaNOfAPointOn) {
  const double nan = std::nan("");
  const Material material({"exp(-d)"});
  EXPECT_TRUE(std::isnan(value_at(material, Vec3(nan, 0, 0))));
  double low = 0.0, high = 0.0;
  material.bounds({Vec3(nan, 0, 0), Vec3(1, 1, 1)}, &low, &high);
  EXPECT_TRUE(std::isnan(low) && std::isnan(high));
}

TEST(Material, ServesManyThreadsAtOnce) {
  std::mt19937 random(29);
  std::vector<Vec3> points(20000);
  for (Vec3& p : points) p = random_point(random, 5.0);
  const Material material({"exp(-0.3*d)*(x > y ? cos(theta) : sqrt(r + 1)) + x^3"}, {}, rotated_frame());
  std::vector<double> expected(points.size());
  std::vector<Vec3> expected_gradients(points.size());
  material.evaluate(points.data(), points.size(), expected.data(), expected_gradients.data());

  std::vector<int> wrong(8, 0);
  std::vector<std::thread> threads;
  for (int& faults : wrong) {
    threads.emplace_back([&] {
      std::vector<double> values(points.size());
      std::vector<Vec3> gradients(points.size());
      for (int round = 0; round < 5; ++round) {
        material.evaluate(points.data(), points.size(), values.data(), gradients.data());
        faults += values != expected || gradients != expected_gradients;
        double low = 0.0, high = 0.0;
        material.bounds({points[0], points[0]}, &low, &high);
        faults += !(low <= expected[0] && expected[0] <= high);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(8, 0));
}

}  // namespace
}  // namespace fgmesh::test
