// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "core/vec3.hpp"

namespace fgmesh::brep {

/// The nearest of a fixed set of points: a balanced kd-tree whose nodes are the middles of the ranges of one
/// array.
class NearestPoint {
 public:
  NearestPoint() = default;
  explicit NearestPoint(const std::vector<Vec3>& points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    nodes_.resize(points.size());
    build(points, order, 0, static_cast<int>(points.size()));
  }

  /// Index into the points given to the constructor; -1 where there were none.
  int operator()(const Vec3& p) const {
    Best best;
    search(p, 0, static_cast<int>(nodes_.size()), best);
    return best.index;
  }

 private:
  struct Node {
    Vec3 point;
    int index;
    int axis;
  };
  struct Best {
    double distance2 = std::numeric_limits<double>::infinity();
    int index = -1;
  };

  void build(const std::vector<Vec3>& points, std::vector<int>& order, int begin, int end) {
    if (begin == end) return;
    Vec3 low = points[order[begin]], high = low;
    for (int i = begin; i < end; ++i) {
      low = low.cwiseMin(points[order[i]]);
      high = high.cwiseMax(points[order[i]]);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const int middle = begin + (end - begin) / 2;
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                     [&](int a, int b) { return points[a][axis] < points[b][axis]; });
    nodes_[middle] = {points[order[middle]], order[middle], axis};
    build(points, order, begin, middle);
    build(points, order, middle + 1, end);
  }

  void search(const Vec3& p, int begin, int end, Best& best) const {
    if (begin == end) return;
    const int middle = begin + (end - begin) / 2;
    const Node& node = nodes_[middle];
    const double distance2 = (node.point - p).squaredNorm();
    if (distance2 < best.distance2) best = {distance2, node.index};
    const double side = p[node.axis] - node.point[node.axis];
    const bool low_first = side < 0.0;
    low_first ? search(p, begin, middle, best) : search(p, middle + 1, end, best);
    if (side * side >= best.distance2) return;
    low_first ? search(p, middle + 1, end, best) : search(p, begin, middle, best);
  }

  std::vector<Node> nodes_;
};

}  // namespace fgmesh::brep
