// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brep/brep_model.hpp"
#include "core/run_control.hpp"

namespace fgmesh {

/// Throws GeometryError for a shape that could not be meshed. Where OpenCASCADE finds that parts of the shape
/// cross or touch each other, these are named as the cause, with `fault` behind; else `fault` is all.
[[noreturn]] void refuse_with_cause(const std::string& fault, const BrepModel& model, RunControl& control);

}  // namespace fgmesh
