// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "core/tet_mesh.hpp"

namespace fgmesh {

/// What a reader calls a part of the shape: "Edge7".
using PartName = std::function<std::string(const Carrier&)>;

}  // namespace fgmesh
