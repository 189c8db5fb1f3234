// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "material/interval.hpp"

namespace fgmesh {

/// What a formula may read at a point. Lengths in mm, the angle in radians. The coordinates are those in the
/// material's frame; distances to references follow them: d1 s1 d2 s2 ..., and behind these tables: t1 t2 ...
enum class Variable : std::size_t { kX, kY, kZ, kRadius, kAngle, kDistance };
constexpr std::size_t kCoordinateCount = 6;

/// "d3" or "s3": the distance to the third reference (index 2), or that with a sign.
struct ReferenceDistance {
  std::size_t index;
  bool is_signed;
};
Variable to_variable(const ReferenceDistance& distance);
/// None for a coordinate or a table.
std::optional<ReferenceDistance> to_reference(Variable variable);

/// Index, from 0, of the table whose value is meant.
Variable table_variable(std::size_t index);
/// None for a coordinate or a distance.
std::optional<std::size_t> to_table(Variable variable);

bool is_letter(char c);
bool is_digit(char c);

/// That of a coordinate.
std::optional<Variable> find_variable(std::string_view name);
std::string_view variable_name(Variable coordinate);

/// A number of the language and an interval that holds it exactly: pi is no double.
struct Constant {
  double value;
  Interval bounds;
};

std::optional<Constant> find_constant(std::string_view name);

/// What a number with the unit `name` behind it is multiplied by to be in mm or radians. Units are no names
/// otherwise: a parameter may be called "mm".
std::optional<Constant> find_unit(std::string_view name);

/// "d1", "s2", ... where the number is at most 9999.
std::optional<ReferenceDistance> find_reference(std::string_view name);

/// Index of the table that "t1", "t2", ... names, where the number is at most 9999.
std::optional<std::size_t> find_table(std::string_view name);

/// "d1", "s2", "t1", ...: distances to references, and tables.
bool is_numbered_name(std::string_view name);

/// Throws InvalidInput, naming the parameter, for a name that is none or is taken, and for a value not
/// finite.
void check_parameters(const std::map<std::string, double>& parameters);

/// " Did you mean 'alpha'?" where some known name is close to `name`; else a list of what there is.
std::string name_hint(std::string_view name, const std::map<std::string, double>& parameters);

}  // namespace fgmesh
