// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tet_score.hpp"

namespace fgmesh {

QualityGoal quality_goal(double anisotropy) {
  QualityGoal goal;
  const double less = std::pow(anisotropy, -0.3);  // as far as five test solids let both criteria be met
  goal.smallest_angle *= less;
  goal.largest_angle = 180.0 - less * (180.0 - goal.largest_angle);
  return goal;
}

double TetScore::of(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) const {
  if (!is_positive(a.position, b.position, c.position, d.position)) {
    const double squared = squared_edges(a.position, b.position, c.position, d.position);
    return orientation(a.position, b.position, c.position, d.position) / (squared * std::sqrt(squared)) -
           1e-3;
  }
  double score = 1.0;
  const double variation = fgmesh::variation(a, b, c, d);
  // The floor keeps angles from being given up for a tetrahedron that no move can bring below the threshold
  // (a jump).
  constexpr double kMaterialFloor = 0.7;
  if (goal_.material && variation > state_.threshold())
    score = std::max(kMaterialFloor, state_.threshold() / variation);
  const AngleRange angles = dihedral_range(a.position, b.position, c.position, d.position);
  score = std::min(score, angles.smallest / goal_.smallest_angle);
  return std::min(score, (180.0 - angles.largest) / (180.0 - goal_.largest_angle));
}

}  // namespace fgmesh
