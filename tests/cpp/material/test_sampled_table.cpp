// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "material/sampled_table.hpp"
#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

using Axis = SampledTable::Axis;
using Function = std::function<double(double, double, double)>;

/// Samples of a function of the coordinates of up to three axes.
std::shared_ptr<SampledTable> sampled(std::vector<Axis> axes, const Function& function) {
  std::vector<Axis> all = axes;
  while (all.size() < 3) all.push_back({Variable::kZ, {0.0}});
  std::vector<double> values;
  for (const double a : all[0].places)
    for (const double b : all[1].places)
      for (const double c : all[2].places) values.push_back(function(a, b, c));
  return std::make_shared<SampledTable>(std::move(axes), std::move(values));
}

std::vector<double> uneven_places(int count, double low, double high) {
  std::vector<double> places;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    places.push_back(low + (high - low) * t * t);
  }
  return places;
}

const Function kMultilinear = [](double x, double y, double z) {
  return 0.5 + 0.1 * x - 0.2 * y + 0.03 * z + 0.01 * x * y - 0.02 * y * z + 0.004 * x * y * z;
};

std::vector<Axis> box_axes() {
  return {{Variable::kX, uneven_places(5, -4.0, 4.0)},
          {Variable::kY, uneven_places(2, -4.0, 4.0)},
          {Variable::kZ, uneven_places(7, -4.0, 4.0)}};
}

Material material(const std::string& formula, const Tables& tables, const Frame& frame = {}) {
  return Material({formula}, {}, frame, {}, tables);
}

TEST(SampledTables, GiveBackMultilinearFunctions) {
  std::mt19937 random(5);
  const Frame frame = rotated_frame();
  const Material solid = material("t1", {sampled(box_axes(), kMultilinear)}, frame);
  for (int i = 0; i < 200; ++i) {
    const Vec3 local = random_point(random, 4.0);
    const Vec3 p = frame.origin + frame.rotation * local;
    EXPECT_NEAR(value_at(solid, p), kMultilinear(local.x(), local.y(), local.z()), 1e-13);
    const double x = local.x(), y = local.y(), z = local.z();
    const Vec3 slope(0.1 + 0.01 * y + 0.004 * y * z, -0.2 + 0.01 * x - 0.02 * z + 0.004 * x * z,
                     0.03 - 0.02 * y + 0.004 * x * y);
    EXPECT_LT((gradient_at(solid, p) - frame.rotation * slope).norm(), 1e-13);
  }
}

TEST(SampledTables, AreExactAtSamplesAndConstantOutside) {
  const auto table = sampled({{Variable::kX, {0.0, 1.0, 4.0}}}, [](double x, double, double) {
    return x == 0.0 ? 0.1 : x == 1.0 ? 0.7 : 0.3;
  });
  const Material solid = material("t1", {table});
  const auto at = [](double x) { return Vec3(x, 9.0, -9.0); };
  EXPECT_EQ(value_at(solid, at(0.0)), 0.1);
  EXPECT_EQ(value_at(solid, at(1.0)), 0.7);
  EXPECT_EQ(value_at(solid, at(4.0)), 0.3);
  EXPECT_EQ(value_at(solid, at(-1.0)), 0.1);
  EXPECT_EQ(value_at(solid, at(1e9)), 0.3);
  EXPECT_EQ(gradient_at(solid, at(-1.0)), Vec3(0, 0, 0));
  EXPECT_EQ(gradient_at(solid, at(4.5)), Vec3(0, 0, 0));
  // On the border the slope is that of inside, where the solid is.
  EXPECT_NEAR(gradient_at(solid, at(0.0)).x(), 0.6, 1e-15);
  EXPECT_NEAR(gradient_at(solid, at(4.0)).x(), -0.4 / 3.0, 1e-15);
  EXPECT_TRUE(std::isnan(value_at(solid, at(std::nan("")))));
  EXPECT_TRUE(std::isnan(gradient_at(solid, at(std::nan(""))).x()));
}

TEST(SampledTables, TakeEveryCoordinate) {
  // Linear functions of the coordinates themselves, so that the table is exact.
  const std::pair<Variable, std::string> coordinates[] = {
      {Variable::kRadius, "r"}, {Variable::kAngle, "theta"}, {Variable::kDistance, "d"}, {Variable::kZ, "z"}};
  std::mt19937 random(8);
  for (const auto& [coordinate, name] : coordinates) {
    const auto table = sampled({{coordinate, uneven_places(9, -3.14159265358979, 3.14159265358979)}},
                               [](double c, double, double) { return 2.0 * c + 1.0; });
    const Material from_table = material("t1", {table}, rotated_frame());
    const Material direct = material("2*" + name + " + 1", {}, rotated_frame());
    for (int i = 0; i < 100; ++i) {
      const Vec3 p = rotated_frame().origin + random_point(random, 1.5);
      EXPECT_NEAR(value_at(from_table, p), value_at(direct, p), 1e-12) << name;
      EXPECT_LT((gradient_at(from_table, p) - gradient_at(direct, p)).norm(), 1e-11) << name;
    }
  }
}

TEST(SampledTables, StandInFormulasBesideEachOther) {
  const auto one = sampled({{Variable::kX, {-10.0, 10.0}}}, [](double x, double, double) { return x; });
  const auto two = sampled({{Variable::kY, {-10.0, 10.0}}}, [](double y, double, double) { return y; });
  const Material solid = material("exp(0.1*t2)*(1 + t1*t2)", {one, two});
  const Vec3 p(2.0, 3.0, 4.0);
  EXPECT_DOUBLE_EQ(value_at(solid, p), std::exp(0.3) * 7.0);
  const Vec3 slope(std::exp(0.3) * 3.0, std::exp(0.3) * (0.7 + 2.0), 0.0);
  EXPECT_LT((gradient_at(solid, p) - slope).norm(), 1e-13);
}

/// Some hundred random boxes of all sizes, and random points in them.
void expect_bounds_hold(const Material& solid, double reach) {
  std::mt19937 random(11);
  for (int i = 0; i < 400; ++i) {
    const double size = std::pow(10.0, std::uniform_real_distribution<double>(-7.0, 1.0)(random));
    const Vec3 low = random_point(random, reach), sides = size * random_point(random, 1.0).cwiseAbs();
    const Box box{low, low + sides};
    double least = 0.0, most = 0.0;
    solid.bounds(box, &least, &most);
    for (int k = 0; k < 30; ++k) {
      const Vec3 share = 0.5 * (Vec3::Ones() + random_point(random, 1.0));
      const Vec3 p = k == 0 ? low : (low + sides.cwiseProduct(share)).cwiseMin(box.high);
      const double value = value_at(solid, p);
      ASSERT_TRUE(least <= value && value <= most) << value << " outside [" << least << ", " << most << "]";
    }
  }
}

TEST(SampledTables, HaveBoundsThatHold) {
  std::mt19937 random(2);
  const Function noise = [&](double, double, double) {
    return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
  };
  for (const Frame& frame : {Frame{}, rotated_frame()}) {
    expect_bounds_hold(material("t1", {sampled(box_axes(), noise)}, frame), 6.0);
    expect_bounds_hold(material("t1",
                                {sampled({{Variable::kRadius, uneven_places(20, 0.0, 5.0)},
                                          {Variable::kAngle, uneven_places(15, -3.1, 3.1)}},
                                         noise)},
                                frame),
                       6.0);
    // So many samples that wide boxes are looked up in blocks.
    expect_bounds_hold(material("t1",
                                {sampled({{Variable::kX, uneven_places(30, -6.0, 6.0)},
                                          {Variable::kY, uneven_places(41, -6.0, 6.0)},
                                          {Variable::kDistance, uneven_places(52, 0.0, 9.0)}},
                                         noise)},
                                frame),
                       6.0);
    expect_bounds_hold(
        material("t1", {sampled({{Variable::kZ, uneven_places(20011, -6.0, 6.0)}}, noise)}, frame), 6.0);
  }
}

TEST(SampledTables, HaveTightBounds) {
  const Material solid = material(
      "t1", {sampled(box_axes(), [](double x, double y, double z) { return x + 10.0 * y + 100.0 * z; })});
  double low = 0.0, high = 0.0;
  solid.bounds({Vec3(-3, -2, -1), Vec3(3, 2.5, 1)}, &low, &high);
  EXPECT_NEAR(low, -3.0 - 20.0 - 100.0, 1e-11);
  EXPECT_NEAR(high, 3.0 + 25.0 + 100.0, 1e-11);
  solid.bounds({Vec3(-9, -9, -9), Vec3(9, 9, 9)}, &low, &high);
  EXPECT_EQ(low, -444.0);
  EXPECT_EQ(high, 444.0);
  solid.bounds({Vec3(5, 5, 5), Vec3(9, 9, 9)}, &low, &high);
  EXPECT_NEAR(low, 444.0, 1e-11);
  EXPECT_EQ(high, 444.0);
}

TEST(SampledTables, BoundALargeTableQuickly) {
  const auto table = sampled({{Variable::kX, uneven_places(150, -5.0, 5.0)},
                              {Variable::kY, uneven_places(150, -5.0, 5.0)},
                              {Variable::kZ, uneven_places(150, -5.0, 5.0)}},
                             [](double x, double, double) { return x; });
  const auto start = std::chrono::steady_clock::now();
  constexpr int kBoxes = 1000;
  for (int i = 0; i < kBoxes; ++i) {
    const double side = 5.0 * i / kBoxes;
    const Interval reach{-side, side}, box[] = {reach, reach, reach};
    const Interval range = table->bounds(box);
    EXPECT_LE(range.low, -side);
    EXPECT_GE(range.high, side);
    EXPECT_LT(range.high, side + 1.5);  // blocks are 1.34 wide at most
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  EXPECT_LT(seconds.count(), 2.0);
}

TEST(SampledTables, FaultsAreTold) {
  const double infinity = std::numeric_limits<double>::infinity();
  const struct {
    std::vector<Axis> axes;
    std::vector<double> values;
    std::string message;
  } faults[] = {
      {{}, {1.0}, "one to three coordinates"},
      {{{Variable::kX, {1.0}}}, {1.0}, "x needs samples at two places"},
      {{{Variable::kX, {1.0, 0.0}}}, {1.0, 2.0}, "x must ascend"},
      {{{Variable::kX, {1.0, 1.0}}}, {1.0, 2.0}, "x must ascend"},
      {{{Variable::kX, {1.0, infinity}}}, {1.0, 2.0}, "not finite"},
      {{{Variable::kX, {0.0, 1.0}}}, {1.0, std::nan("")}, "value that is not finite"},
      {{{Variable::kX, {0.0, 1.0}}}, {1.0, 2.0, 3.0}, "2 places, but there are 3 values"},
      {{{Variable::kX, {0.0, 1.0}}, {Variable::kX, {0.0, 1.0}}}, {1, 2, 3, 4}, "x stands there twice"},
      {{{Variable::kAngle, {0.0, 360.0}}}, {1.0, 2.0}, "from -pi to pi"},
      {{{Variable::kX, uneven_places(3000, 0.0, 1.0)}, {Variable::kY, uneven_places(3000, 0.0, 1.0)}},
       {},
       "at most 4000000 values"},
  };
  for (const auto& fault : faults) {
    try {
      const SampledTable table(fault.axes, fault.values);
      ADD_FAILURE() << fault.message;
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(fault.message), std::string::npos) << error.what();
    }
  }
}

TEST(SampledTables, MissingOnesAreTold) {
  const auto table = sampled({{Variable::kX, {0.0, 1.0}}}, [](double x, double, double) { return x; });
  const struct {
    std::string formula, message;
    std::size_t position;
  } faults[] = {{"1 + t3", "'t3' is the value of table 3, but only 2 are given", 4},
                {"t99999999999999999999", "only 2 are given", 0},
                {"t1(x)", "is no function", 2},
                {"t01", "unknown name", 0}};
  for (const auto& fault : faults) {
    try {
      material(fault.formula, {table, table});
      ADD_FAILURE() << fault.formula;
    } catch (const FormulaError& error) {
      EXPECT_NE(std::string(error.what()).find(fault.message), std::string::npos) << error.what();
      EXPECT_EQ(error.position(), fault.position) << error.what();
    }
  }
}

}  // namespace
}  // namespace fgmesh::test
