// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace fgmesh {

/// `text` for a message: between quotes, cut after 40 characters, what does not print written as \xNN.
std::string in_quotes(std::string_view text);

/// Throws a FormulaError whose message tells the position as people count, from 1.
[[noreturn]] void fail_at(std::size_t position, const std::string& message);

/// Two lines for a terminal: the part of `text` around `position`, and below it a caret under the character
/// there. `position` counts bytes, as FormulaError does; one behind the end points there.
std::string caret_excerpt(std::string_view text, std::size_t position);

}  // namespace fgmesh
