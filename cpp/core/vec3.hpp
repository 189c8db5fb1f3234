// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace fgmesh {

/// A point or a direction in space; lengths are mm throughout.
using Vec3 = Eigen::Vector3d;

/// An axis-aligned box.
struct Box {
  Vec3 low = Vec3::Constant(0.0);
  Vec3 high = Vec3::Constant(0.0);

  double diagonal() const { return (high - low).norm(); }
};

}  // namespace fgmesh
