// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/meshing_options.hpp"

#include <cmath>
#include <sstream>

#include "core/error.hpp"

namespace fgmesh {
namespace {

template <class Value>
[[noreturn]] void refuse(const char* option, const Value& value, const char* allowed) {
  std::ostringstream text;
  text << option << " is " << value << ", but must be " << allowed;
  throw InvalidInput(text.str());
}

void check_length(const char* option, double value) {
  if (!std::isfinite(value) || value < 0.0) refuse(option, value, "a length in mm, or 0 for the default");
}

}  // namespace

void MeshingOptions::validate() const {
  if (!(material_threshold > 0.0 && material_threshold <= 1.0))
    refuse("material_threshold", material_threshold, "above 0 and at most 1");
  check_length("surface_deviation", surface_deviation);
  check_length("min_size", min_size);
  check_length("max_size", max_size);
  if (min_size > 0.0 && max_size > 0.0 && min_size > max_size)
    refuse("min_size", min_size, "at most max_size");
  if (!(anisotropy >= 1.0 && anisotropy <= 10.0)) refuse("anisotropy", anisotropy, "from 1 to 10");
  if (order != 1 && order != 2) refuse("order", order, "1 or 2");
  if (stop_after != "initial" && stop_after != "material" && stop_after != "geometry")
    refuse("stop_after", '"' + stop_after + '"', "\"initial\", \"material\" or \"geometry\"");
  if (threads < 0) refuse("threads", threads, "0 (all processors) or more");
}

}  // namespace fgmesh
