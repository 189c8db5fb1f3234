// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/crossing_parts.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/error.hpp"
#include "pipeline/given_numbers.hpp"

namespace fgmesh {

void refuse_with_cause(const std::string& fault, const BrepModel& model, RunControl& control) {
  constexpr std::size_t kMostPairs = 3;
  std::vector<std::array<Carrier, 2>> crossing;
  try {
    crossing = model.self_interferences(control);
  } catch (const GeometryError&) {
    // Where OpenCASCADE cannot tell the cause, what is known must do.
  }
  if (crossing.empty()) throw GeometryError(fault);
  std::string pairs;
  for (std::size_t i = 0; i < std::min(crossing.size(), kMostPairs); ++i)
    pairs += (i == 0 ? "" : ", ") + given_name(crossing[i][0], model.origins()) + " and " +
             given_name(crossing[i][1], model.origins());
  throw GeometryError("parts of the shape cross or touch each other: " + pairs +
                      (crossing.size() > kMostPairs ? " and others" : "") +
                      "; move them apart, or unite them with Part -> Boolean (" + fault + ")");
}

}  // namespace fgmesh
