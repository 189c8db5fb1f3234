// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/formula_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

#include "material/formula_error.hpp"
#include "material/formula_operation.hpp"

namespace fgmesh {
namespace {

constexpr std::size_t kMaxNumber = 9999;  // of a reference or a table
constexpr std::size_t kFirstTable = kCoordinateCount + 2 * kMaxNumber;

constexpr std::array<std::string_view, kCoordinateCount> kVariableNames = {"x", "y", "z", "r", "theta", "d"};

struct NamedConstant {
  std::string_view name;
  double value;  // the double just below the true number
};
constexpr std::array<NamedConstant, 2> kConstants = {
    {{"pi", 3.141592653589793116}, {"e", 2.718281828459045091}}};

constexpr NamedConstant kUnits[] = {{"nm", 1e-6},
                                    {"um", 1e-3},
                                    {"mm", 1.0},
                                    {"cm", 10.0},
                                    {"m", 1e3},
                                    {"thou", 0.0254},
                                    {"in", 25.4},
                                    {"ft", 304.8},
                                    {"yd", 914.4},
                                    {"rad", 1.0},
                                    {"deg", 1.7453292519943295e-2}};

bool is_identifier(std::string_view name) {
  return !name.empty() && is_letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [](char c) { return is_letter(c) || is_digit(c); });
}

bool is_reserved(std::string_view name) {
  return find_variable(name) || find_constant(name) || find_function(name) || is_numbered_name(name);
}

/// Of a numbered name, where it is at most kMaxNumber.
std::optional<std::size_t> number_of(std::string_view name) {
  constexpr std::size_t kMostDigits = 4;
  if (!is_numbered_name(name) || name.size() > 1 + kMostDigits) return std::nullopt;
  return std::stoul(std::string(name.substr(1)));
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Levenshtein's distance, blind to case.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::vector<std::string_view> known_names(const std::map<std::string, double>& parameters) {
  std::vector<std::string_view> names;
  for (const auto& parameter : parameters) names.push_back(parameter.first);
  for (const Operation& function : formula_functions()) names.push_back(function.name);
  names.insert(names.end(), kVariableNames.begin(), kVariableNames.end());
  for (const NamedConstant& constant : kConstants) names.push_back(constant.name);
  return names;
}

}  // namespace

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<Variable> find_variable(std::string_view name) {
  const auto found = std::find(kVariableNames.begin(), kVariableNames.end(), name);
  if (found == kVariableNames.end()) return std::nullopt;
  return static_cast<Variable>(found - kVariableNames.begin());
}

std::string_view variable_name(Variable coordinate) {
  return kVariableNames[static_cast<std::size_t>(coordinate)];
}

std::optional<Constant> find_unit(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kUnits), std::end(kUnits),
                                         [&](const NamedConstant& unit) { return unit.name == name; });
  if (found == std::end(kUnits)) return std::nullopt;
  const double value = found->value;
  if (value == std::floor(value)) return Constant{value, Interval::point(value)};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return Constant{value, {std::nextafter(value, -infinity), std::nextafter(value, infinity)}};
}

std::optional<Constant> find_constant(std::string_view name) {
  for (const NamedConstant& constant : kConstants) {
    if (constant.name != name) continue;
    return Constant{
        constant.value,
        {constant.value, std::nextafter(constant.value, std::numeric_limits<double>::infinity())}};
  }
  return std::nullopt;
}

Variable to_variable(const ReferenceDistance& distance) {
  return static_cast<Variable>(kCoordinateCount + 2 * distance.index + (distance.is_signed ? 1 : 0));
}

std::optional<ReferenceDistance> to_reference(Variable variable) {
  const std::size_t place = static_cast<std::size_t>(variable);
  if (place < kCoordinateCount || place >= kFirstTable) return std::nullopt;
  return ReferenceDistance{(place - kCoordinateCount) / 2, (place - kCoordinateCount) % 2 == 1};
}

Variable table_variable(std::size_t index) { return static_cast<Variable>(kFirstTable + index); }

std::optional<std::size_t> to_table(Variable variable) {
  const std::size_t place = static_cast<std::size_t>(variable);
  if (place < kFirstTable) return std::nullopt;
  return place - kFirstTable;
}

std::optional<ReferenceDistance> find_reference(std::string_view name) {
  const auto number = number_of(name);
  if (!number || name[0] == 't') return std::nullopt;
  return ReferenceDistance{*number - 1, name[0] == 's'};
}

std::optional<std::size_t> find_table(std::string_view name) {
  const auto number = number_of(name);
  if (!number || name[0] != 't') return std::nullopt;
  return *number - 1;
}

bool is_numbered_name(std::string_view name) {
  return name.size() >= 2 && (name[0] == 'd' || name[0] == 's' || name[0] == 't') && name[1] != '0' &&
         std::all_of(name.begin() + 1, name.end(), is_digit);
}

void check_parameters(const std::map<std::string, double>& parameters) {
  for (const auto& [name, value] : parameters) {
    if (!is_identifier(name)) {
      throw InvalidInput("parameter " + in_quotes(name) +
                         " has no usable name: take letters a-z, digits and _, a letter first");
    }
    if (is_reserved(name)) {
      throw InvalidInput("parameter " + in_quotes(name) +
                         " bears a name that formulas use already: give it another one");
    }
    if (!std::isfinite(value))
      throw InvalidInput("parameter " + in_quotes(name) + " must be a finite number");
  }
}

std::string name_hint(std::string_view name, const std::map<std::string, double>& parameters) {
  constexpr std::size_t kLongestCompared = 40;
  std::string_view nearest;
  // One slip in three letters may be a typing error; more is another word.
  std::size_t smallest = std::max<std::size_t>(1, name.size() / 3) + 1;
  for (const std::string_view known : known_names(parameters)) {
    if (std::max(name.size(), known.size()) > kLongestCompared) continue;
    const std::size_t distance = edit_distance(name, known);
    if (distance < smallest && distance < name.size()) {
      smallest = distance;
      nearest = known;
    }
  }
  if (!nearest.empty()) return "; did you mean " + in_quotes(nearest) + "?";
  std::string hint = "; a formula knows x y z r theta d pi e, its functions";
  if (parameters.empty()) return hint + " and the parameters you give (none here)";
  hint += " and the parameters";
  std::size_t listed = 0;
  for (const auto& parameter : parameters) {
    if (++listed > 10) return hint + " ...";
    hint += " " + parameter.first;
  }
  return hint;
}

}  // namespace fgmesh
