// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/formula_lexer.hpp"

#include <charconv>
#include <system_error>

#include "material/formula_error.hpp"
#include "material/formula_names.hpp"

namespace fgmesh {
namespace {

/// What people write out of habit from other languages, and what to write instead.
struct Habit {
  std::string_view text;
  const char* advice;
};

constexpr Habit kHabits[] = {
    {"**", "'**' is no operator here; write ^ for a power"},
    {"&&", "there is no '&&'; multiply conditions: (x > 0)*(y > 0)"},
    {"||", "there is no '||'; write max(x > 0, y > 0)"},
    {"&", "there is no '&'; multiply conditions: (x > 0)*(y > 0)"},
    {"|", "there is no '|'; write max(x > 0, y > 0), or abs(x) for a magnitude"},
    {"!", "there is no '!'; turn the comparison round, or write (...) == 0"},
    {"%", "there is no '%'; the remainder of a/b is a - b*floor(a/b)"},
    {"=", "a formula assigns nothing; write == to compare"},
};

constexpr std::string_view kSymbols[] = {"<=", ">=", "==", "!=", "+", "-", "*", "/",
                                         "^",  "<",  ">",  "?",  ":", "(", ")", ","};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool starts_with(std::string_view text, std::string_view beginning) {
  return text.substr(0, beginning.size()) == beginning;
}

}  // namespace

Token FormulaLexer::take(Token::Kind kind, std::size_t length) {
  Token token;
  token.kind = kind;
  token.text = text_.substr(position_, length);
  token.position = position_;
  position_ += length;
  return token;
}

Token FormulaLexer::next() {
  while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
  if (position_ == text_.size()) return take(Token::Kind::kEnd, 0);
  const char first = text_[position_];
  const bool point_then_digit =
      first == '.' && position_ + 1 < text_.size() && is_digit(text_[position_ + 1]);
  if (is_digit(first) || point_then_digit) return number();
  if (!is_letter(first)) return symbol();
  std::size_t end = position_;
  while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
  return take(Token::Kind::kName, end - position_);
}

Token FormulaLexer::number() {
  std::size_t end = position_;
  const auto skip_digits = [&] {
    const std::size_t begin = end;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    return end > begin;
  };
  skip_digits();
  if (end < text_.size() && text_[end] == '.') {
    ++end;
    skip_digits();
  }
  if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
    const std::size_t exponent = end++;
    if (end < text_.size() && (text_[end] == '+' || text_[end] == '-')) ++end;
    if (!skip_digits()) {
      fail_at(exponent, "the exponent of the number has no digits; write 1e-3, or 2*e for Euler's number");
    }
  }
  Token token = take(Token::Kind::kNumber, end - position_);
  const char* const last = token.text.data() + token.text.size();
  if (std::from_chars(token.text.data(), last, token.number).ec != std::errc()) {
    fail_at(token.position,
            "the number " + in_quotes(token.text) + " is beyond what a double holds (1e-308 to 1e308)");
  }
  return token;
}

Token FormulaLexer::symbol() {
  const std::string_view rest = text_.substr(position_);
  for (const Habit& habit : kHabits) {
    const bool is_comparison = starts_with(rest, "==") || starts_with(rest, "!=");
    if (!is_comparison && starts_with(rest, habit.text)) fail_at(position_, habit.advice);
  }
  for (const std::string_view symbol : kSymbols) {
    if (starts_with(rest, symbol)) return take(Token::Kind::kSymbol, symbol.size());
  }
  if (rest[0] == '\0') fail_at(position_, "the formula holds a NUL byte");
  // Four bytes show any one character of UTF-8; in_quotes() would show what follows it too.
  std::size_t length = 1;
  while (static_cast<unsigned char>(rest[0]) >= 0xC0 && length < 4 && length < rest.size() &&
         (static_cast<unsigned char>(rest[length]) & 0xC0u) == 0x80u) {
    ++length;
  }
  fail_at(position_, "the character " + in_quotes(rest.substr(0, length)) + " belongs to no formula");
}

}  // namespace fgmesh
