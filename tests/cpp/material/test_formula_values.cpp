// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <muParser.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <limits>

#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct KnownValue {
  const char* formula;
  double value;
};

class KnownValues : public testing::TestWithParam<KnownValue> {};

TEST_P(KnownValues, AreMet) {
  const double value = value_of(GetParam().formula, Vec3(2.0, -3.0, 0.5));
  EXPECT_DOUBLE_EQ(value, GetParam().value) << GetParam().formula;
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, KnownValues,
    testing::Values(KnownValue{"-2^2", -4.0}, KnownValue{"2^-1", 0.5}, KnownValue{"2^3^2", 512.0},
                    KnownValue{"(2^3)^2", 64.0}, KnownValue{"-x^2", -4.0}, KnownValue{"2^-x^2", 0.0625},
                    KnownValue{"8/4/2", 1.0}, KnownValue{"8-4-2", 2.0}, KnownValue{"2+3*4", 14.0},
                    KnownValue{"--x", 2.0}, KnownValue{"+-+x", -2.0}, KnownValue{"2*-x", -4.0},
                    KnownValue{" x\t*\ny\r", -6.0}, KnownValue{".5 + 1. + 1.e1 + 2E-1", 11.7},
                    KnownValue{"x < 3 ? 1 : 2", 1.0}, KnownValue{"x > 3 ? 1 : x > 1 ? 5 : 6", 5.0},
                    KnownValue{"1 + 1 == 2", 1.0}, KnownValue{"x != 2", 0.0}, KnownValue{"x <= 2", 1.0},
                    KnownValue{"x >= 2.5", 0.0}, KnownValue{"(x > 0)*(y < 0)", 1.0},
                    KnownValue{"if(y, 7, 8)", 7.0}, KnownValue{"if(0, 7, 8)", 8.0},
                    KnownValue{"e", 2.718281828459045}, KnownValue{"pi", 3.141592653589793},
                    KnownValue{"log(e)", 1.0}, KnownValue{"log10(1000)", 3.0}));

INSTANTIATE_TEST_SUITE_P(
    Functions, KnownValues,
    testing::Values(KnownValue{"cbrt(-27)", -3.0}, KnownValue{"cbrt(y*9)", -3.0}, KnownValue{"sign(y)", -1.0},
                    KnownValue{"sign(0)", 0.0}, KnownValue{"floor(y/2)", -2.0}, KnownValue{"ceil(y/2)", -1.0},
                    KnownValue{"min(x, y, z, 9)", -3.0}, KnownValue{"max(y, z, x, -9)", 2.0},
                    KnownValue{"clamp(y, -1, 1)", -1.0}, KnownValue{"clamp(x, 5, 7)", 5.0},
                    KnownValue{"clamp(z, 0, 1)", 0.5}, KnownValue{"mix(10, 20, z)", 15.0},
                    KnownValue{"step(2, x)", 1.0}, KnownValue{"step(2.1, x)", 0.0},
                    KnownValue{"smoothstep(0, 1, z)", 0.5}, KnownValue{"smoothstep(0, 8, x)", 0.15625},
                    KnownValue{"smoothstep(0, 1, y)", 0.0}, KnownValue{"smoothstep(0, 1, x)", 1.0},
                    KnownValue{"smoothstep(2, 2, x)", 1.0}, KnownValue{"smoothstep(8, 0, x)", 0.84375},
                    KnownValue{"pow(y, 3)", -27.0}, KnownValue{"y^-2", 1.0 / 9.0}, KnownValue{"0^0", 1.0},
                    KnownValue{"r", 3.605551275463989}, KnownValue{"d", 3.640054944640259},
                    KnownValue{"theta", -0.982793723247329}, KnownValue{"atan2(1, -1)", 2.356194490192345}));

TEST(FormulaValues, ANumberMayHaveAUnit) {
  EXPECT_DOUBLE_EQ(value_of("80 mm", Vec3::Zero()), 80.0);
  EXPECT_DOUBLE_EQ(value_of("1in", Vec3::Zero()), 25.4);
  EXPECT_DOUBLE_EQ(value_of("2 ft", Vec3::Zero()), 609.6);
  EXPECT_DOUBLE_EQ(value_of("1.5e-1 cm", Vec3::Zero()), 1.5);
  EXPECT_DOUBLE_EQ(value_of("250 um + 1 thou", Vec3::Zero()), 0.2754);
  EXPECT_DOUBLE_EQ(value_of("-(2 cm)^2", Vec3::Zero()), -400.0);
  EXPECT_DOUBLE_EQ(value_of("1 m/2 m", Vec3::Zero()), 0.5) << "a unit binds tighter than a quotient";
  EXPECT_DOUBLE_EQ(value_of("sin(30 deg)", Vec3::Zero()), 0.5);
  EXPECT_DOUBLE_EQ(value_of("x/1 in", Vec3(50.8, 0.0, 0.0)), 2.0);
}

TEST(FormulaValues, UndefinedIsNaNAndUnboundedIsInfinite) {
  for (const char* formula :
       {"log(-x)", "sqrt(y)", "asin(x)", "0/0", "(x-2)/(x-2)", "y^0.5", "max(sqrt(y), 1)", "min(1, sqrt(y))",
        "step(sqrt(y), 0)", "sqrt(y) > 0", "if(sqrt(y), 1, 1)", "clamp(sqrt(y), 0, 1)", "sqrt(y)^0",
        "1^sqrt(y)", "sign(sqrt(y))", "smoothstep(0, 1, sqrt(y))"}) {
    EXPECT_TRUE(std::isnan(value_of(formula, Vec3(2.0, -3.0, 0.5)))) << formula;
  }
  EXPECT_EQ(value_of("1/d", Vec3::Zero()), kInfinity);
  EXPECT_EQ(value_of("log(d)", Vec3::Zero()), -kInfinity);
  EXPECT_EQ(value_of("1/(-d)", Vec3::Zero()), kInfinity) << "zero has no sign";
  EXPECT_EQ(value_of("(-d)^-1", Vec3::Zero()), kInfinity) << "zero has no sign";
}

TEST(FormulaValues, OnlyTheBranchTakenDecides) {
  EXPECT_EQ(value_of("if(x > 0, log(x), 0)", Vec3(-1.0, 0.0, 0.0)), 0.0);
  EXPECT_EQ(value_of("x > 0 ? log(x) : 0", Vec3(1.0, 0.0, 0.0)), 0.0);
  EXPECT_TRUE(std::isnan(value_of("x > 0 ? log(-x) : 0", Vec3(1.0, 0.0, 0.0))));
}

TEST(FormulaValues, TheAngleHasOneValueOnItsCut) {
  EXPECT_DOUBLE_EQ(value_of("theta", Vec3(-1.0, 0.0, 0.0)), M_PI);
  EXPECT_DOUBLE_EQ(value_of("theta", Vec3(-1.0, -0.0, 0.0)), M_PI);
  EXPECT_DOUBLE_EQ(value_of("atan2(-y, x)", Vec3(-1.0, 0.0, 0.0)), M_PI);
  EXPECT_DOUBLE_EQ(value_of("theta", Vec3(-1.0, -1e-300, 0.0)), -M_PI);
  EXPECT_EQ(value_of("theta", Vec3::Zero()), 0.0);
}

TEST(FormulaValues, ParametersAreTheirNumbersAndMayIdle) {
  EXPECT_DOUBLE_EQ(value_of("alpha*x_1", Vec3::Zero(), {{"alpha", 0.5}, {"x_1", 8.0}, {"unused", 1.0}}), 4.0);
  EXPECT_DOUBLE_EQ(value_of("d0", Vec3::Zero(), {{"d0", 3.0}}), 3.0);
}

TEST(FormulaValues, NumbersReadTheSameInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  // Where the German locale is not installed this tests the plain one: no harm.
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_DOUBLE_EQ(value_of("1.5*2"), 3.0);
  std::setlocale(LC_ALL, before.c_str());
}

/// Writes random expressions that muParser reads the same way.
class ExpressionWriter {
 public:
  explicit ExpressionWriter(unsigned seed) : random_(seed) {}

  /// `total`: built of nothing that can be undefined, since in muParser NaN < 1, NaN^0 and 1^NaN are numbers.
  std::string expression(int depth, bool total = false) {
    if (depth == 0) return leaf();
    switch (pick(total ? 7 : 10)) {
      case 0:
        return leaf();
      case 1:
        return "(" + expression(depth - 1, total) + ")";
      case 2:
        return "(-" + expression(depth - 1, total) + ")";
      case 3:
      case 4:
        return expression(depth - 1, total) + one_of({" + ", "-", "*"}) + expression(depth - 1, total);
      case 5:
        return one_of({"sin", "cos", "tanh", "atan", "abs"}) + "(" + expression(depth - 1, total) + ")";
      case 6:
        return "(" + expression(depth - 1, true) + one_of({"<", "<=", ">", ">=", "==", "!="}) +
               expression(depth - 1, true) + " ? " + expression(depth - 1, total) + " : " +
               expression(depth - 1, total) + ")";
      case 7:
        if (pick(2)) return expression(depth - 1) + "/" + expression(depth - 1);
        return expression(depth - 1, true) + "^" + expression(depth - 1, true);
      case 8:
        return one_of({"exp", "log", "log10", "sqrt", "asin", "acos", "tan", "sinh", "cosh"}) + "(" +
               expression(depth - 1) + ")";
      default:
        return one_of({"min", "max", "atan2"}) + "(" + expression(depth - 1, true) + ", " +
               expression(depth - 1, true) + ")";
    }
  }

  std::mt19937& random() { return random_; }

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  std::string one_of(const std::vector<std::string>& choices) {
    return choices[static_cast<std::size_t>(pick(static_cast<int>(choices.size())))];
  }
  std::string leaf() {
    return one_of({"x", "y", "z", "r", "theta", "d", "alpha", "2", "3", "0.5", "1.25e-1", "7."});
  }

  std::mt19937 random_;
};

class MuParser {
 public:
  explicit MuParser(const std::string& formula) {
    const char* const names[] = {"x", "y", "z", "r", "theta", "d"};
    for (int i = 0; i < 6; ++i) parser_.DefineVar(names[i], &variables_[i]);
    parser_.DefineConst("alpha", 0.37);
    parser_.SetExpr(formula);
  }

  double at(const Vec3& p) {
    const double values[] = {p[0], p[1], p[2], std::hypot(p[0], p[1]), std::atan2(p[1], p[0]), p.norm()};
    std::copy(std::begin(values), std::end(values), variables_);
    return parser_.Eval();
  }

 private:
  mu::Parser parser_;
  double variables_[6] = {};
};

/// How far muParser's own answer moves when its input does by a few roundings: no program can agree better.
double conditioning(MuParser& reference, const Vec3& p) {
  const double here = reference.at(p);
  double change = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3 moved = p;
      moved[axis] *= 1.0 + sign * 1e-13;
      const double there = reference.at(moved);
      if (std::isnan(here) != std::isnan(there)) return kInfinity;
      if (!std::isnan(there - here)) change = std::max(change, std::fabs(there - here));
    }
  }
  return change;
}

TEST(FormulaValues, AgreeWithMuParserOnRandomExpressions) {
  ExpressionWriter writer(20240607);
  int compared = 0, finite = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::string formula = writer.expression(1 + i % 4);
    MuParser reference(formula);
    const Material material({formula}, {{"alpha", 0.37}});
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = random_point(writer.random(), 3.0);
      const double expected = reference.at(p), got = value_at(material, p);
      const double slack = conditioning(reference, p);
      if (!(slack < 1e-3 * (1.0 + std::fabs(expected))) && std::isfinite(expected)) continue;
      ++compared;
      finite += std::isfinite(expected);
      if (std::isnan(expected) || std::isinf(expected)) {
        EXPECT_TRUE(std::isnan(expected) ? std::isnan(got) : got == expected || std::fabs(got) > 1e300)
            << formula << " at " << p.transpose() << ": " << expected << " / " << got;
      } else {
        EXPECT_NEAR(got, expected, 1e-12 * (1.0 + std::fabs(expected)) + 10.0 * slack)
            << formula << " at " << p.transpose();
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(compared, 50000);
  EXPECT_GT(finite, 30000);
}

}  // namespace
}  // namespace fgmesh::test
