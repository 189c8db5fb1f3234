// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/formula_parser.hpp"

#include "material/formula_error.hpp"
#include "material/formula_lexer.hpp"

namespace fgmesh {
namespace {

using Operand = ProgramBuilder::Operand;

/// For "but ... given".
std::string how_many(std::size_t count) {
  if (count == 0) return "none is";
  if (count == 1) return "only one is";
  return "only " + std::to_string(count) + " are";
}

class FormulaParser {
 public:
  FormulaParser(std::string_view text, const std::map<std::string, double>& parameters,
                const std::vector<Reference>& references, std::size_t table_count)
      : parameters_(parameters), references_(references), table_count_(table_count), lexer_(text) {}

  FormulaProgram parse() {
    advance();
    if (token_.kind == Token::Kind::kEnd) fail_at(0, "the formula is empty");
    const Operand result = expression();
    if (token_.kind != Token::Kind::kEnd) fail_unexpected();
    return builder_.finish(result);
  }

 private:
  /// Counts one more level of recursion while it lives: the depth of the stack is not the stranger's to
  /// choose.
  class Level {
   public:
    Level(int& depth, std::size_t position) : depth_(depth) {
      if (depth_ >= kMaxFormulaDepth) {
        fail_at(position, "the formula nests deeper than " + std::to_string(kMaxFormulaDepth) + " levels");
      }
      ++depth_;
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    int& depth_;
  };

  Operand expression();
  Operand comparison();
  Operand sum();
  Operand term();
  Operand signed_value();
  Operand power();
  Operand primary();
  Operand group();
  Operand named(const Token& name);
  Operand distance(const Token& name);
  Operand table(const Token& name);
  Operand call(const Token& name, const Operation& function);
  void close(std::size_t opening);
  Operand apply(const Operation& operation, const std::vector<Operand>& operands);
  void advance();
  bool at_comparison() const;
  [[noreturn]] void fail_unexpected() const;
  [[noreturn]] void fail_no_value() const;
  [[noreturn]] void fail_no_function(const Token& name) const;

  const std::map<std::string, double>& parameters_;
  const std::vector<Reference>& references_;
  std::size_t table_count_;
  FormulaLexer lexer_;
  Token token_;     // the one to be read next
  Token previous_;  // the one read last
  int depth_ = 0;
  ProgramBuilder builder_;
};

void FormulaParser::advance() {
  previous_ = token_;
  token_ = lexer_.next();
}

Operand FormulaParser::apply(const Operation& operation, const std::vector<Operand>& operands) {
  const Operand result = builder_.apply(operation, operands);
  if (builder_.register_count() > FormulaProgram::kMaxRegisters) {
    fail_at(token_.position, "the formula has too many intermediate results; simplify it");
  }
  return result;
}

Operand FormulaParser::expression() {
  const Operand condition = comparison();
  if (!token_.is("?")) return condition;
  const std::size_t question = token_.position;
  const Level level(depth_, question);
  advance();
  const Operand if_true = expression();
  if (token_.kind == Token::Kind::kEnd || token_.is(")") || token_.is(",")) {
    fail_at(question, "this '?' has no ':'; write condition ? value : other value");
  }
  if (!token_.is(":")) fail_unexpected();
  advance();
  const Operand if_false = expression();
  return apply(selection(), {condition, if_true, if_false});
}

bool FormulaParser::at_comparison() const {
  return token_.is("<") || token_.is("<=") || token_.is(">") || token_.is(">=") || token_.is("==") ||
         token_.is("!=");
}

Operand FormulaParser::comparison() {
  const Operand left = sum();
  if (!at_comparison()) return left;
  const Operation& operation = *find_operator(token_.text);
  advance();
  const Operand right = sum();
  if (at_comparison()) {
    fail_at(token_.position, "comparisons do not chain; write (a < b)*(b < c) instead of a < b < c");
  }
  return apply(operation, {left, right});
}

Operand FormulaParser::sum() {
  Operand result = term();
  while (token_.is("+") || token_.is("-")) {
    const Operation& operation = *find_operator(token_.text);
    advance();
    const Operand right = term();
    result = apply(operation, {result, right});
  }
  return result;
}

Operand FormulaParser::term() {
  Operand result = signed_value();
  while (token_.is("*") || token_.is("/")) {
    const Operation& operation = *find_operator(token_.text);
    advance();
    const Operand right = signed_value();
    result = apply(operation, {result, right});
  }
  return result;
}

Operand FormulaParser::signed_value() {
  if (!token_.is("-") && !token_.is("+")) return power();
  const Level level(depth_, token_.position);
  const bool negative = token_.is("-");
  advance();
  const Operand operand = signed_value();
  return negative ? apply(negation(), {operand}) : operand;
}

Operand FormulaParser::power() {
  const Operand base = primary();
  if (!token_.is("^")) return base;
  const Level level(depth_, token_.position);
  const Operation& operation = *find_operator(token_.text);
  advance();
  const Operand exponent = signed_value();
  return apply(operation, {base, exponent});
}

Operand FormulaParser::primary() {
  if (token_.is("(")) return group();
  const Token token = token_;
  if (token.kind == Token::Kind::kNumber) {
    advance();
    const Operand number = builder_.constant({token.number, Interval::point(token.number)});
    const auto unit = token_.kind == Token::Kind::kName ? find_unit(token_.text) : std::nullopt;
    if (!unit) return number;
    advance();
    if (token_.is("^")) fail_at(token_.position, "put parentheses around a number with a unit: (2 cm)^2");
    return apply(*find_operator("*"), {number, builder_.constant(*unit)});
  }
  if (token.kind != Token::Kind::kName) fail_no_value();
  advance();
  return named(token);
}

Operand FormulaParser::group() {
  const std::size_t opening = token_.position;
  const Level level(depth_, opening);
  advance();
  if (token_.is(")")) fail_at(opening, "these parentheses hold nothing");
  const Operand result = expression();
  close(opening);
  return result;
}

void FormulaParser::close(std::size_t opening) {
  if (token_.kind == Token::Kind::kEnd) fail_at(opening, "this '(' is never closed; add a ')'");
  if (!token_.is(")")) fail_unexpected();
  advance();
}

Operand FormulaParser::named(const Token& name) {
  const bool called = token_.is("(");
  if (const Operation* const function = find_function(name.text)) {
    if (called) return call(name, *function);
    fail_at(name.position, "the function " + in_quotes(name.text) + " needs its arguments in parentheses");
  }
  if (is_numbered_name(name.text)) {
    if (called) fail_no_function(name);
    return name.text[0] == 't' ? table(name) : distance(name);
  }
  const auto variable = find_variable(name.text);
  const auto constant = find_constant(name.text);
  const auto parameter = parameters_.find(std::string(name.text));
  if (!variable && !constant && parameter == parameters_.end()) {
    fail_at(name.position, (called ? "unknown function " : "unknown name ") + in_quotes(name.text) +
                               name_hint(name.text, parameters_));
  }
  if (called) fail_no_function(name);
  if (variable) return builder_.variable(*variable);
  if (constant) return builder_.constant(*constant);
  return builder_.constant({parameter->second, Interval::point(parameter->second)});
}

Operand FormulaParser::distance(const Token& name) {
  const std::string quoted = in_quotes(name.text);
  const auto found = find_reference(name.text);
  if (!found || found->index >= references_.size()) {
    fail_at(name.position, quoted + " is the distance to reference " + std::string(name.text.substr(1)) +
                               ", but " + how_many(references_.size()) +
                               " given; add the face, edge, vertex or solid that is meant");
  }
  if (found->is_signed && !references_[found->index].is_solid) {
    fail_at(name.position, quoted + " needs a solid, but that reference is " +
                               references_[found->index].name + "; write d" +
                               std::string(name.text.substr(1)) + " for the distance without a sign");
  }
  return builder_.variable(to_variable(*found));
}

Operand FormulaParser::table(const Token& name) {
  const auto found = find_table(name.text);
  if (!found || *found >= table_count_) {
    fail_at(name.position, in_quotes(name.text) + " is the value of table " +
                               std::string(name.text.substr(1)) + ", but " + how_many(table_count_) +
                               " given; add the table that is meant");
  }
  return builder_.variable(table_variable(*found));
}

Operand FormulaParser::call(const Token& name, const Operation& function) {
  const std::size_t opening = token_.position;
  const Level level(depth_, opening);
  const std::size_t arity = static_cast<std::size_t>(function.arity);
  const std::string takes = in_quotes(name.text) + " takes " + std::to_string(arity) +
                            (function.variadic ? " or more" : "") + (arity == 1 ? " argument" : " arguments");
  advance();
  std::vector<Operand> arguments;
  if (!token_.is(")")) {
    arguments.push_back(expression());
    while (token_.is(",")) {
      if (arguments.size() == arity) {
        if (!function.variadic) fail_at(token_.position, takes + "; what follows this comma is too many");
        // At once, so that a long list of arguments needs no more registers than a short one.
        arguments = {apply(function, arguments)};
      }
      advance();
      arguments.push_back(expression());
    }
  }
  if (token_.is(")") && arguments.size() != arity) {
    fail_at(name.position, takes + "; " + std::to_string(arguments.size()) +
                               (arguments.size() == 1 ? " is given" : " are given"));
  }
  close(opening);
  return apply(function, arguments);
}

void FormulaParser::fail_unexpected() const {
  const std::size_t position = token_.position;
  if (token_.is(")")) fail_at(position, "this ')' closes nothing; remove it or add a '('");
  if (token_.is(",")) {
    fail_at(position, "a ',' only separates arguments of a function; decimals are written with a point");
  }
  if (token_.is(":")) fail_at(position, "this ':' has no '?'; write condition ? value : other value");
  if (token_.is("?")) fail_at(position, "a condition cannot follow here; put it into parentheses");
  if (previous_.kind == Token::Kind::kNumber || previous_.kind == Token::Kind::kName || previous_.is(")")) {
    fail_at(position, "an operator is missing between " + in_quotes(previous_.text) + " and " +
                          in_quotes(token_.text) + "; for a product write *");
  }
  fail_at(position, in_quotes(token_.text) + " cannot stand here");
}

void FormulaParser::fail_no_value() const {
  const std::size_t position = token_.position;
  const bool starts = previous_.text.empty();
  if (token_.kind == Token::Kind::kEnd) {
    fail_at(position, "the formula ends after " + in_quotes(previous_.text) + ", where a value must follow");
  }
  const std::string where = starts ? "at the start" : "after " + in_quotes(previous_.text);
  fail_at(position, "a value is expected " + where + ", not " + in_quotes(token_.text));
}

void FormulaParser::fail_no_function(const Token& name) const {
  fail_at(token_.position,
          in_quotes(name.text) + " is no function; for a product write " + std::string(name.text) + "*(...)");
}

}  // namespace

FormulaProgram parse_formula(std::string_view text, const std::map<std::string, double>& parameters,
                             const std::vector<Reference>& references, std::size_t table_count) {
  if (text.size() > kMaxFormulaLength) {
    fail_at(kMaxFormulaLength, "the formula has " + std::to_string(text.size()) + " characters; at most " +
                                   std::to_string(kMaxFormulaLength) + " are allowed");
  }
  return FormulaParser(text, parameters, references, table_count).parse();
}

}  // namespace fgmesh
