// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/piece_tree.hpp"

#include <BVH_BinnedBuilder.hxx>
#include <BVH_BoxSet.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fgmesh::brep {
namespace {

using Corner = BVH_Tree<double, 3>::BVH_VecNt;

Vec3 to_vec3(const Corner& corner) { return {corner.x(), corner.y(), corner.z()}; }
Corner to_corner(const Vec3& p) { return Corner(p.x(), p.y(), p.z()); }

double squared_distance_to_box(const Vec3& p, const Corner& low, const Corner& high) {
  return (p - p.cwiseMax(to_vec3(low)).cwiseMin(to_vec3(high))).squaredNorm();
}

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  return length2 > 0.0 ? Vec3(a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along) : a;
}

/// Of a piece of any kind: a triangle without area is its sides.
Vec3 nearest_on_piece(const Vec3& p, const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double bb = ab.squaredNorm(), bc = ab.dot(ac), cc = ac.squaredNorm();
  const double pb = ap.dot(ab), pc = ap.dot(ac);
  const double area2 = bb * cc - bc * bc;
  // Barycentric coordinates of b and c, times that.
  const double at_b = cc * pb - bc * pc;
  const double at_c = bb * pc - bc * pb;
  const bool is_flat = area2 <= 0.0;
  const bool beyond_ab = is_flat || at_c < 0.0;
  const bool beyond_bc = is_flat || at_b + at_c > area2;
  const bool beyond_ca = is_flat || at_b < 0.0;
  if (!beyond_ab && !beyond_bc && !beyond_ca) return a + (at_b * ab + at_c * ac) / area2;
  Vec3 nearest = a;
  const auto look_at = [&](const Vec3& other) {
    if ((other - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = other;
  };
  if (beyond_ab) look_at(nearest_on_segment(p, a, b));
  if (beyond_bc) look_at(nearest_on_segment(p, b, c));
  if (beyond_ca) look_at(nearest_on_segment(p, c, a));
  return nearest;
}

}  // namespace

PieceTree::PieceTree(std::vector<Piece> pieces) {
  // Boxes are much quicker to look at than triangles, so that leaves are small.
  constexpr int kLeafSize = 2;
  BVH_BoxSet<double, 3, int> boxes(new BVH_BinnedBuilder<double, 3>(kLeafSize));
  boxes.SetSize(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& [a, b, c] = pieces[i].corners;
    const Vec3 margin = Vec3::Constant(pieces[i].thickness);
    boxes.Add(static_cast<int>(i), BVH_Box<double, 3>(to_corner(a.cwiseMin(b).cwiseMin(c) - margin),
                                                      to_corner(a.cwiseMax(b).cwiseMax(c) + margin)));
  }
  tree_ = boxes.BVH();
  pieces_.reserve(pieces.size());
  for (int i = 0; i < boxes.Size(); ++i) pieces_.push_back(pieces[boxes.Element(i)]);
}

void PieceTree::find(const Vec3& p, std::vector<Candidate>& candidates) const {
  candidates.clear();
  double at_most = std::numeric_limits<double>::infinity();
  const auto to_node = [&](int node) {
    return squared_distance_to_box(p, tree_->MinPoint(node), tree_->MaxPoint(node));
  };
  // Twice the depth that OpenCASCADE's builders stop at.
  std::array<std::pair<double, int>, 2 * BVH_Constants_MaxTreeDepth> open;
  std::size_t open_count = 0;
  open[open_count++] = {to_node(0), 0};
  while (open_count > 0) {
    const auto [squared_distance, node] = open[--open_count];
    if (squared_distance > at_most * at_most) continue;
    if (!tree_->IsOuter(node)) {
      std::pair<double, int> near(0.0, tree_->Child<0>(node)), far(0.0, tree_->Child<1>(node));
      near.first = to_node(near.second);
      far.first = to_node(far.second);
      if (far.first < near.first) std::swap(near, far);
      open[open_count++] = far;
      open[open_count++] = near;
      continue;
    }
    for (int i = tree_->BegPrimitive(node); i <= tree_->EndPrimitive(node); ++i) {
      const Vec3 nearest = nearest_on_piece(p, pieces_[i].corners);
      const double distance = (nearest - p).norm();
      const double at_least = distance - pieces_[i].thickness;
      if (at_least > at_most) continue;
      candidates.push_back({at_least, i, nearest});
      at_most = std::min(at_most, distance + pieces_[i].thickness);
    }
  }
  const auto beyond = [&](const Candidate& candidate) { return candidate.at_least > at_most; };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), beyond), candidates.end());
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.at_least < b.at_least; });
}

}  // namespace fgmesh::brep
