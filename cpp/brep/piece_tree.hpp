// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BVH_Tree.hxx>
#include <array>
#include <vector>

#include "core/vec3.hpp"

namespace fgmesh::brep {

/// A sample of a shape and the part of its face or edge that it stands for: a triangle; a segment, whose last
/// two corners are one; or a point, whose corners are all one.
struct Piece {
  std::array<Vec3, 3> corners;
  int face = 0;            ///< FaceN of a triangle
  int edge = 0;            ///< EdgeN of a segment
  double thickness = 0.0;  ///< the true part and the sample are nowhere farther from each other, mm
  /// The most that the surface of a triangle bends towards its outer and its inner side, 1/mm.
  std::array<double, 2> curvatures{};
  double low = 0.0, high = 0.0;  ///< parameters of a segment's ends
  int number = 0;                ///< for whoever made it
};

/// Finds the pieces that may hold the nearest point of what they stand for. Immutable.
class PieceTree {
 public:
  struct Candidate {
    double at_least = 0.0;  ///< no point that the piece stands for is nearer, mm
    int piece = -1;
    Vec3 nearest = Vec3::Zero();  ///< point of the piece
  };

  /// `pieces` must not be empty.
  explicit PieceTree(std::vector<Piece> pieces);

  const Piece& piece(int index) const { return pieces_[index]; }

  /// All pieces that may hold the point nearest to `p`, the most promising first.
  void find(const Vec3& p, std::vector<Candidate>& candidates) const;

 private:
  std::vector<Piece> pieces_;  // in the tree's order
  opencascade::handle<BVH_Tree<double, 3>> tree_;
};

}  // namespace fgmesh::brep
