// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/formula_error.hpp"

#include <algorithm>
#include <cstdio>

namespace fgmesh {
namespace {

/// Length of the valid UTF-8 sequence of more than one byte at the start of `text`; 0 where there is none.
std::size_t multibyte_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80u) return 0;
  }
  // Overlong forms, surrogates and what lies beyond Unicode would break whoever decodes the message.
  const unsigned second = byte(1);
  if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0)) return 0;
  if ((lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90)) return 0;
  return length;
}

bool printable(char c) { return c >= ' ' && c <= '~'; }

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "'";
  for (std::size_t i = 0; i < text.size();) {
    if (i >= kLongest) {
      result += "...";
      break;
    }
    if (const std::size_t length = multibyte_length(text.substr(i))) {
      result += text.substr(i, length);
      i += length;
      continue;
    }
    if (printable(text[i])) {
      result += text[i];
    } else {
      char code[8];
      std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(text[i])));
      result += code;
    }
    ++i;
  }
  return result + "'";
}

void fail_at(std::size_t position, const std::string& message) {
  throw FormulaError(message + " (character " + std::to_string(position + 1) + ")", position);
}

std::string caret_excerpt(std::string_view text, std::size_t position) {
  constexpr std::size_t kSide = 40;
  position = std::min(position, text.size());
  const std::size_t begin = position > kSide ? position - kSide : 0;
  const std::size_t end = std::min(text.size(), position + kSide);
  std::string line = begin > 0 ? "..." : "";
  std::size_t column = line.size();
  for (std::size_t i = begin; i < end;) {
    const std::size_t length = multibyte_length(text.substr(i));
    if (length) {
      line += text.substr(i, length);
    } else {
      line += printable(text[i])                                      ? text[i]
              : text[i] == '\n' || text[i] == '\t' || text[i] == '\r' ? ' '
                                                                      : '?';
    }
    if (i < position) ++column;
    i += length ? length : 1;
  }
  if (end < text.size()) line += "...";
  return line + "\n" + std::string(column, ' ') + "^";
}

}  // namespace fgmesh
