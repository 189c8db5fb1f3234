// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <vector>

#include "domain/cgal_types.hpp"

namespace fgmesh {

/// Calls visit(t, u) for every two of `triangles` without a common vertex that cut or touch each other.
/// `corners` gives the three vertices of triangle t, `position` the place of a vertex.
template <class Corners, class Position, class Visit>
void for_each_crossing(const std::vector<int>& triangles, const Corners& corners, const Position& position,
                       const Visit& visit) {
  using Triangle = CgalKernel::Triangle_3;
  using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  const auto triangle = [&](int t) {
    const std::array<int, 3>& v = corners(t);
    return Triangle(to_cgal(position(v[0])), to_cgal(position(v[1])), to_cgal(position(v[2])));
  };
  std::vector<TriangleBox> boxes;
  for (int t : triangles) boxes.emplace_back(triangle(t).bbox(), t);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const TriangleBox& a, const TriangleBox& b) {
    const int t = a.info(), u = b.info();
    const std::array<int, 3>&v = corners(t), &w = corners(u);
    if (std::find_first_of(v.begin(), v.end(), w.begin(), w.end()) != v.end()) return;
    const Triangle first = triangle(t), second = triangle(u);
    if (!first.is_degenerate() && !second.is_degenerate() && CGAL::do_intersect(first, second)) visit(t, u);
  });
}

}  // namespace fgmesh
