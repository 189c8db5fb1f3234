// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/reference.hpp"
#include "material/formula_program.hpp"

namespace fgmesh {

constexpr std::size_t kMaxFormulaLength = 10000;
constexpr int kMaxFormulaDepth = 100;

/// Reads a formula over x y z r theta d, pi, e, `parameters` (checked already), distances d1 s1 ... to
/// `references` and values t1 t2 ... of `table_count` tables into a program:
///
///     expression = comparison [ "?" expression ":" expression ]
///     comparison = sum [ ("<" | "<=" | ">" | ">=" | "==" | "!=") sum ]
///     sum        = term { ("+" | "-") term }
///     term       = signed { ("*" | "/") signed }
///     signed     = ("+" | "-") signed | power
///     power      = primary [ "^" signed ]
///     primary    = number | name | name "(" expression { "," expression } ")" | "(" expression ")"
///
/// Nothing but numbers can come of it, whoever wrote the text. Throws FormulaError, with the position, where
/// the text is none, is longer than kMaxFormulaLength bytes or nests deeper than kMaxFormulaDepth.
FormulaProgram parse_formula(std::string_view text, const std::map<std::string, double>& parameters,
                             const std::vector<Reference>& references, std::size_t table_count);

}  // namespace fgmesh
