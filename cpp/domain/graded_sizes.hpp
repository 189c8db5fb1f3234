// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vec3.hpp"

namespace fgmesh {

/// A triangle, or a segment whose last two corners are alike, at which elements are to have `size`, mm.
struct SizeSource {
  std::array<Vec3, 3> corner;
  double size = 0.0;
};

/// The sizes that sources leave to the elements around them: each its own, and `growth` more with every mm
/// of distance. Sources lie in a tree of boxes, so that a look at it takes about a microsecond.
class GradedSizes {
 public:
  GradedSizes(std::vector<SizeSource> sources, double growth);

  /// The size at a point, mm; `most` where no source asks for less.
  double at(const Vec3& point, double most) const;

 private:
  struct Node {
    Box box;
    double size = 0.0;          ///< the least of its sources
    int first = 0, last = 0;    ///< its sources
    int left = -1, right = -1;  ///< nodes that share them; -1: none
  };
  int build(int first, int last);
  double bound(const Node& node, const Vec3& point) const;
  void look(int node, const Vec3& point, double& size) const;

  std::vector<SizeSource> sources_;
  std::vector<Node> nodes_;  ///< the first holds all
  double growth_;
};

}  // namespace fgmesh
