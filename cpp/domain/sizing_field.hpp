// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec3.hpp"

namespace fgmesh {

/// The local element size wanted by the material, mu = C / |grad f| (paper, equation 2.7), kept within
/// [min_size, max_size] where the gradient explodes or vanishes. Between neighbouring points it may grow by
/// at most `growth` mm a mm: a Lipschitz bound, without which jumps of size ruin the angles.
struct SizingField {
  double constant = 0.1;
  double min_size = 0.0;  ///< mm
  double max_size = 1.0;  ///< mm
  double growth = 0.5;
  double anisotropy = 1.0;  ///< how many times longer elements may be across the gradient than along it

  double at(const Vec3& gradient) const;
};

}  // namespace fgmesh
