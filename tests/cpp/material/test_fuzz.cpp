// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "material/formula_error.hpp"
#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

const std::vector<Vec3>& probes() {
  static const std::vector<Vec3> points = {Vec3(0, 0, 0),      Vec3(1, 0, 0),      Vec3(-1, 0, 0),
                                           Vec3(0.3, -0.2, 7), Vec3(-2, -3, 1e-9), Vec3(1e6, -1e6, 1)};
  return points;
}

/// What holds for every formula that parses, however odd.
void expect_sane(const std::string& text, const Material& material) {
  for (const Vec3& p : probes()) {
    double value = 0.0, alone = 0.0, low = 0.0, high = 0.0;
    Vec3 gradient;
    material.evaluate(&p, 1, &value, &gradient);
    material.evaluate(&p, 1, &alone);
    ASSERT_TRUE(value == alone || (std::isnan(value) && std::isnan(alone))) << in_quotes(text);
    ASSERT_EQ(gradient.hasNaN(), std::isnan(value)) << text;
    material.bounds({p - Vec3(0.5, 0.5, 0.5), p + Vec3(0.25, 0, 1)}, &low, &high);
    ASSERT_TRUE(!std::isfinite(value) || (low <= value && value <= high))
        << text << " at " << p.transpose() << ": " << value << " outside [" << low << ", " << high << "]";
  }
}

bool parses(const std::string& text) {
  try {
    expect_sane(text, Material({text}, {{"alpha", 0.08}}));
    return true;
  } catch (const FormulaError& error) {
    EXPECT_LE(error.position(), text.size());
    EXPECT_GT(std::string(error.what()).size(), 10u);
    EXPECT_NE(caret_excerpt(text, error.position()).find('^'), std::string::npos);
    return false;
  }
}

template <class Pick>
std::string soup(Pick pick, int pieces) {
  std::string text;
  for (int i = 0; i < pieces; ++i) text += pick();
  return text;
}

TEST(Fuzz, RandomBytesParseOrAreRefused) {
  std::mt19937 random(31);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 60);
  for (int i = 0; i < 50000 && !HasFailure(); ++i) {
    parses(soup([&] { return std::string(1, static_cast<char>(byte(random))); }, length(random)));
  }
}

TEST(Fuzz, TokenSoupParsesOrIsRefused) {
  const std::vector<std::string> tokens = {
      "x",    "y",    "z",     "r",      "theta",  "d",      "alpha",  "pi",   "e",    "1",     "0",
      "-0",   "2",    "+",     "-",      "*",      "/",      "^",      "^",    "(",    "(",     ")",
      ")",    ",",    "?",     ":",      "<",      ">=",     "==",     "exp(", "log(", "sqrt(", "pow(",
      "min(", "max(", "sin(",  "tan(",   "if(",    "acos(",  "1e",     " ",    "d1",   "cbrt(", "step(",
      "mix(", "0.5",  "1e308", "atan2(", "clamp(", "floor(", "1e-308", "!="};
  std::mt19937 random(37);
  std::uniform_int_distribution<std::size_t> token(0, tokens.size() - 1);
  std::uniform_int_distribution<int> length(1, 12);
  int accepted = 0;
  for (int i = 0; i < 200000 && !HasFailure(); ++i) {
    accepted += parses(soup([&] { return tokens[token(random)]; }, length(random)));
  }
  EXPECT_GT(accepted, 2000);
}

/// Expressions that are right by construction, of operands chosen to hit zeros, poles and cuts.
std::string right_expression(std::mt19937& random, int depth) {
  const auto pick = [&](const std::vector<std::string>& from) {
    return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random)];
  };
  const auto inner = [&] { return right_expression(random, depth - 1); };
  if (depth == 0)
    return pick({"x", "y", "z", "r", "theta", "d", "0", "1", "(-1)", "2", "0.5", "1e308", "alpha"});
  switch (std::uniform_int_distribution<int>(0, 5)(random)) {
    case 0:
      return "(" + inner() + pick({"+", "-", "*", "/", "^", "<", "<=", ">", ">=", "==", "!="}) + inner() +
             ")";
    case 1:
      return pick({"exp", "log", "log10", "sqrt", "cbrt", "abs", "sign", "sin", "cos", "tan", "asin", "acos",
                   "atan", "sinh", "cosh", "tanh", "floor", "ceil", "-"}) +
             "(" + inner() + ")";
    case 2:
      return pick({"min", "max", "pow", "atan2", "step"}) + "(" + inner() + "," + inner() + ")";
    case 3:
      return pick({"clamp", "mix", "smoothstep", "if"}) + "(" + inner() + "," + inner() + "," + inner() + ")";
    case 4:
      return "(" + inner() + pick({"+", "-", "*", "/", "^"}) + inner() + ")";
    default:
      return inner();
  }
}

TEST(Fuzz, RightExpressionsParseAndBehave) {
  std::mt19937 random(41);
  for (int i = 0; i < 60000 && !HasFailure(); ++i) {
    const std::string text = right_expression(random, 1 + i % 5);
    EXPECT_TRUE(text.size() > 10000 || parses(text)) << text;
  }
}

}  // namespace
}  // namespace fgmesh::test
