// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace fgmesh {

struct Token {
  enum class Kind { kNumber, kName, kSymbol, kEnd };

  Kind kind = Kind::kEnd;
  std::string_view text;  ///< a part of the formula; empty at its end
  std::size_t position = 0;
  double number = 0.0;

  bool is(std::string_view symbol) const { return kind == Kind::kSymbol && text == symbol; }
};

/// Splits a formula into numbers, names and symbols, one at a time. Numbers are read the same in every
/// locale.
class FormulaLexer {
 public:
  explicit FormulaLexer(std::string_view text) : text_(text) {}

  /// Throws FormulaError at the first character that belongs to no formula.
  Token next();

 private:
  Token number();
  Token symbol();
  Token take(Token::Kind kind, std::size_t length);

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace fgmesh
