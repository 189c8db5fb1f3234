// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/boundary_geometry.hpp"

namespace fgmesh {

/// How thick the solids are behind a point of their boundary, by rays through the samples.
class WallThickness {
 public:
  explicit WallThickness(const SampledBoundary& samples);
  ~WallThickness();

  /// Length of the way from `point` on `face` along `inward` to where it leaves `solid`, mm. Infinite where
  /// it does not, or leaves by a face that meets `face` at an edge in a wedge of 12 degrees or more, or at a
  /// sharp seam of the same face.
  double at(const Vec3& point, const Vec3& inward, int solid, int face) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace fgmesh
