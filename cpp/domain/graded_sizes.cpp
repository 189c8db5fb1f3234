// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/graded_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fgmesh {
namespace {

double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 way = b - a;
  const double whole = way.squaredNorm();
  const double part = whole > 0.0 ? std::clamp((point - a).dot(way) / whole, 0.0, 1.0) : 0.0;
  return (point - a - part * way).norm();
}

double distance(const std::array<Vec3, 3>& corner, const Vec3& point) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  bool above = !normal.isZero();
  double nearest = distance_to_segment(corner[2], corner[0], point);
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = corner[i], &b = corner[(i + 1) % 3];
    above = above && (b - a).cross(point - a).dot(normal) >= 0.0;
    if (i < 2) nearest = std::min(nearest, distance_to_segment(a, b, point));
  }
  return above ? std::abs(normal.dot(point - corner[0])) / normal.norm() : nearest;
}

}  // namespace

GradedSizes::GradedSizes(std::vector<SizeSource> sources, double growth)
    : sources_(std::move(sources)), growth_(growth) {
  if (!sources_.empty()) build(0, static_cast<int>(sources_.size()));
}

int GradedSizes::build(int first, int last) {
  constexpr int kFew = 4;
  const int own = static_cast<int>(nodes_.size());
  const Vec3& start = sources_[first].corner[0];
  Node node{{start, start}, sources_[first].size, first, last};
  for (int i = first; i < last; ++i) {
    for (const Vec3& corner : sources_[i].corner) {
      node.box.low = node.box.low.cwiseMin(corner);
      node.box.high = node.box.high.cwiseMax(corner);
    }
    node.size = std::min(node.size, sources_[i].size);
  }
  nodes_.push_back(node);
  if (last - first <= kFew) return own;
  int axis;
  (node.box.high - node.box.low).maxCoeff(&axis);
  const auto along = [axis](const SizeSource& source) {
    return source.corner[0][axis] + source.corner[1][axis] + source.corner[2][axis];
  };
  const int middle = (first + last) / 2;
  std::nth_element(sources_.begin() + first, sources_.begin() + middle, sources_.begin() + last,
                   [&](const SizeSource& a, const SizeSource& b) { return along(a) < along(b); });
  const int left = build(first, middle), right = build(middle, last);
  nodes_[own].left = left;
  nodes_[own].right = right;
  return own;
}

/// No source of the node leaves less than this.
double GradedSizes::bound(const Node& node, const Vec3& point) const {
  const Vec3 outside = (node.box.low - point).cwiseMax(point - node.box.high).cwiseMax(0.0);
  return node.size + growth_ * outside.norm();
}

void GradedSizes::look(int index, const Vec3& point, double& size) const {
  const Node& node = nodes_[index];
  if (bound(node, point) >= size) return;
  if (node.left < 0) {
    for (int i = node.first; i < node.last; ++i)
      if (sources_[i].size < size)
        size = std::min(size, sources_[i].size + growth_ * distance(sources_[i].corner, point));
    return;
  }
  int near = node.left, far = node.right;
  if (bound(nodes_[far], point) < bound(nodes_[near], point)) std::swap(near, far);
  look(near, point, size);
  look(far, point, size);
}

double GradedSizes::at(const Vec3& point, double most) const {
  if (!nodes_.empty()) look(0, point, most);
  return most;
}

}  // namespace fgmesh
