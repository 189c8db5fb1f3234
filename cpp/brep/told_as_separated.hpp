// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.hpp"

namespace fgmesh::brep {

/// Runs `action`; where the solids were separated before it, its GeometryError says that the numbers it tells
/// are those of the separated solids.
template <class Action>
auto told_as_separated(bool separated, const Action& action) {
  try {
    return action();
  } catch (const GeometryError& error) {
    if (!separated) throw;
    throw GeometryError(std::string(error.what()) +
                        " (numbers as after Part -> Boolean -> Boolean Fragments of the touching solids)");
  }
}

}  // namespace fgmesh::brep
