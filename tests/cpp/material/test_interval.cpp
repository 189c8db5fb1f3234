// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace fgmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Numbers of every magnitude, and now and then a zero or a small whole number.
double any_double(std::mt19937_64& random) {
  switch (std::uniform_int_distribution<int>(0, 7)(random)) {
    case 0:
      return 0.0;
    case 1:
      return std::uniform_int_distribution<int>(-4, 4)(random);
    case 2:
      return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random),
                        std::uniform_int_distribution<int>(-1000, 1000)(random));
    default:
      return std::uniform_real_distribution<double>(-10, 10)(random);
  }
}

/// The exact result lies in `bounds` and the bounds are neighbours of it. A long double errs by 2^-64
/// relative, which can hide neither: it is nearer to the exact result than any double but the exact one.
void expect_tight(const Interval& bounds, long double exact, const char* what) {
  EXPECT_LE(static_cast<long double>(bounds.low), exact) << what;
  EXPECT_GE(static_cast<long double>(bounds.high), exact) << what;
  if (std::isfinite(bounds.low) && std::isfinite(bounds.high)) {
    EXPECT_LE(bounds.high - bounds.low, 2.0 * kEpsilon * std::fabs(bounds.high) + 1e-320) << what;
  }
}

TEST(Interval, ArithmeticEnclosesTheExactResultTightly) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 200000 && !testing::Test::HasFailure(); ++i) {
    const double a = any_double(random), b = any_double(random);
    const Interval ia = Interval::point(a), ib = Interval::point(b);
    const long double la = a, lb = b;
    // A long double holds sums of numbers of similar size exactly enough; very unequal ones it cannot judge.
    if (a == 0.0 || b == 0.0 || std::fabs(std::ilogb(a) - std::ilogb(b)) < 8)
      expect_tight(ia + ib, la + lb, "+");
    expect_tight(ia * ib, la * lb, "*");
    if (b != 0.0) expect_tight(ia / ib, la / lb, "/");
    if (a >= 0.0) expect_tight(sqrt(ia), std::sqrt(la), "sqrt");
  }
}

TEST(Interval, ExactResultsStayPoints) {
  EXPECT_TRUE((Interval::point(0.5) + Interval::point(0.25)).is_point());
  EXPECT_TRUE((Interval::point(0.5) * Interval::point(3.0)).is_point());
  EXPECT_TRUE((Interval::point(1.0) / Interval::point(8.0)).is_point());
  EXPECT_TRUE(sqrt(Interval::point(25.0)).is_point());
  EXPECT_FALSE((Interval::point(1.0) / Interval::point(3.0)).is_point());
  EXPECT_FALSE((Interval::point(0.1) + Interval::point(0.2)).is_point());
  EXPECT_FALSE((Interval::point(1.0) + Interval::point(1e-300)).is_point());
}

void expect_interval(const Interval& got, double low, double high) {
  const auto near = [](double a, double b) {
    return a == b || std::fabs(a - b) <= 1e-14 * (1.0 + std::fabs(b));
  };
  EXPECT_TRUE(near(got.low, low) && near(got.high, high))
      << "[" << got.low << ", " << got.high << "] instead of [" << low << ", " << high << "]";
  EXPECT_LE(got.low, low);
  EXPECT_GE(got.high, high);
}

TEST(Interval, ProductsAndQuotientsOfEverySign) {
  expect_interval(Interval{-2, 3} * Interval{-5, 7}, -15, 21);
  expect_interval(Interval{-2, -1} * Interval{3, 4}, -8, -3);
  expect_interval(Interval{0, 1} * Interval{0, kInfinity}, 0, kInfinity);
  expect_interval(Interval{1, 2} / Interval{4, 8}, 0.125, 0.5);
  expect_interval(Interval{-1, 2} / Interval{4, 8}, -0.25, 0.5);
  expect_interval(Interval{1, 2} / Interval{0, 4}, 0.25, kInfinity);
  expect_interval(Interval{1, 2} / Interval{-4, 0}, -kInfinity, kInfinity);
  expect_interval(Interval{-2, -1} / Interval{0, 4}, -kInfinity, -0.25);
  expect_interval(Interval{1, 2} / Interval{-1, 4}, -kInfinity, kInfinity);
  expect_interval(square(Interval{-2, 1}), 0, 4);
  expect_interval(abs(Interval{-2, 1}), 0, 2);
}

TEST(Interval, WavesKnowTheirCrests) {
  expect_interval(sin(Interval{0, 1}), 0, std::sin(1.0));
  expect_interval(sin(Interval{1, 2}), std::sin(1.0), 1);
  expect_interval(sin(Interval{4, 5}), -1, std::sin(4.0));
  expect_interval(sin(Interval{0, 7}), -1, 1);
  expect_interval(cos(Interval{-1, 1}), std::cos(1.0), 1);
  expect_interval(cos(Interval{3, 4}), -1, std::cos(4.0));
  expect_interval(cos(Interval{1e300, 1e300}), -1, 1);
  expect_interval(tan(Interval{-1, 1}), std::tan(-1.0), std::tan(1.0));
  expect_interval(tan(Interval{1, 2}), -kInfinity, kInfinity);
}

TEST(Interval, PowersOfEverySign) {
  expect_interval(pow(Interval{-2, 1}, Interval::point(2)), 0, 4);
  expect_interval(pow(Interval{-2, 1}, Interval::point(3)), -8, 1);
  expect_interval(pow(Interval{-2, -1}, Interval::point(-1)), -1, -0.5);
  expect_interval(pow(Interval{-2, 1}, Interval::point(-2)), 0.25, kInfinity);
  expect_interval(pow(Interval{-2, 1}, Interval::point(-1)), -kInfinity, kInfinity);
  expect_interval(pow(Interval{0, 2}, Interval::point(-1)), 0.5, kInfinity);
  expect_interval(pow(Interval{-2, 4}, Interval::point(0.5)), 0, 2);
  expect_interval(pow(Interval{0.5, 2}, Interval{-1, 3}), 0.125, 8);
  expect_interval(pow(Interval{-2, -1}, Interval{1.5, 3.5}), -std::pow(2.0, 3.5), std::pow(2.0, 3.5));
  expect_interval(pow(Interval{-0.0, -0.0}, Interval{-1, 1}), 0, kInfinity);
  EXPECT_TRUE(pow(Interval{-2, -1}, Interval::point(0.5)).is_empty());
  EXPECT_TRUE(pow(Interval{-2, -1}, Interval{1.2, 1.8}).is_empty());
}

TEST(Interval, FunctionsKeepToTheirDomain) {
  expect_interval(log(Interval{-1, 1}), -kInfinity, 0);
  expect_interval(sqrt(Interval{-1, 4}), 0, 2);
  expect_interval(asin(Interval{0, 9}), 0, M_PI_2);
  expect_interval(acos(Interval{-9, 0}), M_PI_2, M_PI);
  EXPECT_TRUE(log(Interval{-2, -1}).is_empty());
  EXPECT_TRUE(sqrt(Interval{-2, -1}).is_empty());
  EXPECT_TRUE(asin(Interval{2, 3}).is_empty());
}

TEST(Interval, AnglesKnowTheirCut) {
  expect_interval(atan2(Interval{1, 2}, Interval{1, 2}), std::atan2(1, 2), std::atan2(2, 1));
  expect_interval(atan2(Interval{-1, 1}, Interval{1, 2}), -M_PI_4, M_PI_4);
  expect_interval(atan2(Interval{-1, 1}, Interval{-2, -1}), -M_PI, M_PI);
  expect_interval(atan2(Interval{0, 1}, Interval{-2, -1}), std::atan2(1, -1), M_PI);
  expect_interval(atan2(Interval{-1, 1}, Interval{-1, 1}), -M_PI, M_PI);
  expect_interval(atan2(Interval{0, 1}, Interval{-1, 1}), 0, M_PI);
}

TEST(Interval, RangesOfFunctionsAreNotOverstepped) {
  EXPECT_GE(exp(Interval{-2000, -1000}).low, 0.0);
  EXPECT_GT(exp(Interval{-2000, -1000}).high, 0.0);
  EXPECT_LE(tanh(Interval{50, 60}).high, 1.0);
  EXPECT_GE(cosh(Interval{-1, 1}).low, 1.0);
  EXPECT_LE(sin(Interval{1.5, 1.6}).high, 1.0);
  // exp(1000) is about 2e434: finite, but beyond every double.
  EXPECT_EQ(exp(Interval{1000, 1000}).low, std::numeric_limits<double>::max());
  EXPECT_EQ(exp(Interval{1000, 1000}).high, kInfinity);
}

}  // namespace
}  // namespace fgmesh
