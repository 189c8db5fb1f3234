// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "core/error.hpp"
#include "material/formula_error.hpp"
#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

using namespace std::string_literals;

struct BadFormula {
  std::string formula;
  std::size_t position;
  std::string message;  ///< a part of it
};

class BadFormulas : public testing::TestWithParam<BadFormula> {};

TEST_P(BadFormulas, SayWhatAndWhere) {
  try {
    Material({GetParam().formula}, {{"alpha", 0.08}});
    FAIL() << "accepted: " << GetParam().formula;
  } catch (const FormulaError& error) {
    EXPECT_EQ(error.position(), GetParam().position) << error.what();
    EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Lexer, BadFormulas,
                         testing::Values(BadFormula{"", 0, "is empty"}, BadFormula{" \n\t", 0, "is empty"},
                                         BadFormula{"x\0y"s, 1, "NUL byte"}, BadFormula{"\0"s, 0, "NUL byte"},
                                         BadFormula{"1e999", 0, "beyond what a double holds"},
                                         BadFormula{"x + 2e", 5, "exponent"},
                                         BadFormula{"2e+x", 1, "exponent"}, BadFormula{"x**2", 1, "write ^"},
                                         BadFormula{"x = 2", 2, "write == to compare"},
                                         BadFormula{"x && y", 2, "multiply"}, BadFormula{"x || y", 2, "max"},
                                         BadFormula{"!x", 0, "no '!'"}, BadFormula{"x % 2", 2, "floor"},
                                         BadFormula{"2*\xCE\xB1", 2, "'\xCE\xB1'"},
                                         BadFormula{"2*\xFF", 2, "'\\xff'"}, BadFormula{"x.real", 1, "'.'"},
                                         BadFormula{"'x'", 0, "belongs to no formula"},
                                         BadFormula{"x; y", 1, "';'"}, BadFormula{"[x]", 0, "'['"}));

INSTANTIATE_TEST_SUITE_P(
    Names, BadFormulas,
    testing::Values(BadFormula{"exp(-alpa*d)", 5, "did you mean 'alpha'?"},
                    BadFormula{"X", 0, "did you mean 'x'?"}, BadFormula{"2*Exp(x)", 2, "did you mean 'exp'?"},
                    BadFormula{"1 + radius", 4, "unknown name 'radius'; a formula knows x y z r theta d"},
                    BadFormula{"frobnicate(x)", 0, "unknown function 'frobnicate'"},
                    BadFormula{"d1 + 1", 0, "distance to reference 1, but none is given"},
                    BadFormula{"1 + s2", 4, "distance to reference 2, but none is given"},
                    BadFormula{"t10 + x", 0, "value of table 10, but none is given"},
                    BadFormula{"import os", 0, "unknown name 'import'"},
                    BadFormula{"__import__('os').system('true')", 0, "unknown function '__import__'"},
                    BadFormula{"lambda x: x", 0, "unknown name 'lambda'"},
                    BadFormula{"x if x > 0 else 1", 2, "operator is missing"},
                    BadFormula{"alpha(2)", 5, "write alpha*(...)"}, BadFormula{"x(2)", 1, "write x*(...)"},
                    BadFormula{"exp x", 0, "in parentheses"}, BadFormula{"2*sin", 2, "in parentheses"}));

INSTANTIATE_TEST_SUITE_P(
    Grammar, BadFormulas,
    testing::Values(BadFormula{"2x", 1, "operator is missing between '2' and 'x'"},
                    BadFormula{"x*2 cm^2", 6, "parentheses around a number with a unit"},
                    BadFormula{"3 furlongs", 2, "operator is missing between '3' and 'furlongs'"},
                    BadFormula{"x y", 2, "operator is missing between 'x' and 'y'"},
                    BadFormula{"(x)(y)", 3, "operator is missing"},
                    BadFormula{"1..2", 2, "operator is missing"}, BadFormula{"x +", 3, "ends after '+'"},
                    BadFormula{"x ^ ", 4, "ends after '^'"}, BadFormula{"*x", 0, "at the start, not '*'"},
                    BadFormula{"x + / y", 4, "after '+', not '/'"}, BadFormula{"(x", 0, "never closed"},
                    BadFormula{"exp((x + 1)", 3, "never closed"}, BadFormula{"x)", 1, "closes nothing"},
                    BadFormula{"()", 0, "hold nothing"}, BadFormula{"1,5", 1, "decimals"},
                    BadFormula{"(1, 5)", 2, "decimals"}, BadFormula{"0 < x < 1", 6, "do not chain"},
                    BadFormula{"x ? y", 2, "has no ':'"}, BadFormula{"(x > 0 ? y)", 7, "has no ':'"},
                    BadFormula{"x : y", 2, "has no '?'"}, BadFormula{"x ? : y", 4, "after '?', not ':'"}));

INSTANTIATE_TEST_SUITE_P(Arity, BadFormulas,
                         testing::Values(BadFormula{"1 + exp()", 4, "'exp' takes 1 argument; 0 are given"},
                                         BadFormula{"exp(1, 2)", 5,
                                                    "'exp' takes 1 argument; what follows this comma"},
                                         BadFormula{"atan2(x)", 0, "takes 2 arguments; 1 is given"},
                                         BadFormula{"clamp(x, 0)", 0, "takes 3 arguments; 2 are given"},
                                         BadFormula{"mix(1, 2, 3, 4)", 11, "takes 3 arguments"},
                                         BadFormula{"max(x)", 0, "takes 2 or more arguments; 1 is given"},
                                         BadFormula{"if(x, 1)", 0, "'if' takes 3 arguments"},
                                         BadFormula{"max(x,)", 6, "after ',', not ')'"}));

std::string repeated(const std::string& text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

INSTANTIATE_TEST_SUITE_P(
    Limits, BadFormulas,
    testing::Values(BadFormula{std::string(1000000, 'x'), 10000, "1000000 characters; at most 10000"},
                    BadFormula{std::string(100000, '(') + "x" + std::string(100000, ')'), 10000,
                               "at most 10000"},
                    BadFormula{std::string(10000, '('), 100, "deeper than 100"},
                    BadFormula{std::string(101, '(') + "x" + std::string(101, ')'), 100, "deeper than 100"},
                    BadFormula{std::string(9999, '-') + "x", 100, "deeper than 100"},
                    BadFormula{repeated("x^", 4000) + "x", 201, "deeper than 100"},
                    BadFormula{repeated("x?x:", 2000) + "x", 401, "deeper than 100"},
                    BadFormula{repeated("x?", 4000) + "x", 201, "deeper than 100"},
                    BadFormula{repeated("exp(", 2500), 403, "deeper than 100"}));

TEST(FormulaErrors, FormulasJustWithinTheLimitsAreRight) {
  EXPECT_EQ(value_of(std::string(100, '(') + "7" + std::string(100, ')')), 7.0);
  EXPECT_EQ(value_of(repeated("x+", 4999) + "x", Vec3(1.0, 0.0, 0.0)), 5000.0);
  EXPECT_EQ(value_of(repeated("2+", 4999) + "2"), 10000.0);
  EXPECT_EQ(value_of("max(" + repeated("x,", 4000) + "9)"), 9.0);
  // The most registers that a text of this depth and length can ask for.
  const std::string level = "x<x+x*x^max(x+1,mix(x+2,x+3,";
  const std::string greedy = repeated(level, 33) + "x" + repeated("))", 33);
  EXPECT_TRUE(std::isfinite(value_of(greedy, Vec3(1.0, 0.0, 0.0))));
  EXPECT_TRUE(gradient_of(greedy, Vec3(1.0, 0.0, 0.0)).allFinite());
}

TEST(FormulaErrors, EveryMessageOfADifferentFaultDiffers) {
  std::set<std::string> messages;
  const std::vector<std::string> faults = {"",   "x\0"s, "x=1", "os.x", "2x",   "x+",
                                           "(x", "x)",   "()",  "foo",  "exp()"};
  for (const std::string& fault : faults) {
    try {
      Material({fault});
      ADD_FAILURE() << fault;
    } catch (const FormulaError& error) {
      messages.insert(error.what());
    }
  }
  EXPECT_EQ(messages.size(), faults.size());
}

void expect_invalid(const std::function<void()>& make, const std::string& part) {
  try {
    make();
    ADD_FAILURE() << "accepted, though: " << part;
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(MaterialErrors, ParametersNeedFreeNamesAndFiniteValues) {
  for (const char* name : {"x", "theta", "d", "pi", "e", "exp", "if", "clamp", "d1", "s12", "t3"}) {
    expect_invalid([&] { Material({"x"}, {{name, 1.0}}); }, "'"s + name + "' bears a name that formulas use");
  }
  for (const char* name : {"", "2a", "a b", "a-b", "\xCE\xB1", "a\n"}) {
    expect_invalid([&] { Material({"x"}, {{name, 1.0}}); }, "has no usable name");
  }
  expect_invalid([] { Material({"x"}, {{"alpha", std::nan("")}}); }, "'alpha' must be a finite number");
  expect_invalid([] { Material({"x"}, {{"alpha", 1.0 / 0.0}}); }, "'alpha' must be a finite number");
}

TEST(MaterialErrors, OneFormulaOrMoreAndARightHandedFrame) {
  expect_invalid([] { Material({}); }, "needs a formula");
  try {
    Material({"x", "y*w"}, {{"v", 1.0}});
    FAIL() << "w is no name";
  } catch (const FormulaError& error) {
    EXPECT_EQ(error.formula(), 1u);
    EXPECT_EQ(error.position(), 2u);
    EXPECT_EQ(std::string(error.what()).find("formula 2: "), 0u) << error.what();
  }
  Frame frame;
  frame.rotation(0, 0) = -1.0;
  expect_invalid([&] { Material({"x"}, {}, frame); }, "right-handed");
  frame.rotation = 2.0 * Eigen::Matrix3d::Identity();
  expect_invalid([&] { Material({"x"}, {}, frame); }, "unit vectors");
  frame = {};
  frame.origin[1] = std::nan("");
  expect_invalid([&] { Material({"x"}, {}, frame); }, "not finite");
}

TEST(CaretExcerpt, PointsAtTheCharacter) {
  EXPECT_EQ(caret_excerpt("2*foo", 2), "2*foo\n  ^");
  EXPECT_EQ(caret_excerpt("x+", 2), "x+\n  ^");
  EXPECT_EQ(caret_excerpt("a\tb\nc", 4), "a b c\n    ^");
  EXPECT_EQ(caret_excerpt("\xCE\xB1 + \xCE\xB2", 5), "\xCE\xB1 + \xCE\xB2\n    ^");
  EXPECT_EQ(caret_excerpt("x", 99), "x\n ^");
  const std::string excerpt = caret_excerpt(std::string(500, 'y') + "#" + std::string(500, 'y'), 500);
  const std::size_t newline = excerpt.find('\n');
  EXPECT_LT(newline, 100u);
  EXPECT_EQ(excerpt[excerpt.find('^') - newline - 1], '#');
}

TEST(InQuotes, IsShortAndPrintable) {
  EXPECT_EQ(in_quotes("a\x01\xFF"), "'a\\x01\\xff'");
  EXPECT_EQ(in_quotes("\xE2\x82\xAC"), "'\xE2\x82\xAC'");
  // A surrogate and an overlong form are no UTF-8, and would break whoever decodes the message.
  EXPECT_EQ(in_quotes("\xED\xA0\x80"), "'\\xed\\xa0\\x80'");
  EXPECT_EQ(in_quotes("\xC0\x80"), "'\\xc0\\x80'");
  EXPECT_LT(in_quotes(std::string(100000, 'x')).size(), 60u);
}

}  // namespace
}  // namespace fgmesh::test
