// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_score.hpp"

namespace fgmesh {
namespace {

constexpr double kRounding = 1e-12;  // of a cosine

double cosine_of(double angle) { return std::cos(angle / kDegrees); }

}  // namespace

QualityGoal quality_goal(double anisotropy) {
  QualityGoal goal;
  const double less = std::pow(anisotropy, -0.3);  // as far as five test solids let both criteria be met
  goal.smallest_angle *= less;
  goal.largest_angle = 180.0 - less * (180.0 - goal.largest_angle);
  return goal;
}

TetScore::TetScore(const MeshState& state, const QualityGoal& goal)
    : state_(state),
      goal_(goal),
      cosine_of_smallest_(cosine_of(goal.smallest_angle) - kRounding),
      cosine_of_largest_(cosine_of(goal.largest_angle) + kRounding) {}

double TetScore::of(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) const {
  if (!is_positive(a.position, b.position, c.position, d.position)) {
    const double squared = squared_edges(a.position, b.position, c.position, d.position);
    return orientation(a.position, b.position, c.position, d.position) / (squared * std::sqrt(squared)) -
           1e-3;
  }
  double score = 1.0;
  double variation = fgmesh::variation(a, b, c, d);
  if (goal_.between) {
    // What is foretold is not all; and what keeps the threshold with nothing to spare is hard to prove.
    constexpr double kCaution = 1.01;
    const double foretold = foretold_variation(a, b, c, d);
    if (foretold > variation) variation = kCaution * foretold;
  }
  // The floor keeps angles from being given up for a tetrahedron that no move can bring below the threshold
  // (a jump).
  constexpr double kMaterialFloor = 0.7;
  if (goal_.material && variation > state_.threshold())
    score = std::max(kMaterialFloor, state_.threshold() / variation);
  if (goal_.longest_edge < std::numeric_limits<double>::infinity()) {
    const double squared = longest_edge_squared(a.position, b.position, c.position, d.position);
    if (squared > goal_.longest_edge * goal_.longest_edge)
      score = std::min(score, goal_.longest_edge / std::sqrt(squared));
  }
  const std::array<double, 6> cosines = dihedral_cosines(a.position, b.position, c.position, d.position);
  const auto [low, high] = std::minmax_element(cosines.begin(), cosines.end());
  // Most meet both goals, which the cosines tell without their angles.
  if (*high > cosine_of_smallest_) score = std::min(score, angle_of(*high) / goal_.smallest_angle);
  if (*low < cosine_of_largest_)
    score = std::min(score, (180.0 - angle_of(*low)) / (180.0 - goal_.largest_angle));
  return score;
}

}  // namespace fgmesh
