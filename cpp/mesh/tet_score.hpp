// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/foretold_variation.hpp"
#include "mesh/mesh_state.hpp"

namespace fgmesh {

/// What every tetrahedron is asked for.
struct QualityGoal {
  double smallest_angle = 15.0;  ///< degrees
  double largest_angle = 157.0;  ///< degrees
  bool material = true;          ///< the material threshold counts too,
  bool between = false;          ///< and that between the corners, as far as foretold_variation() sees it
  double longest_edge = std::numeric_limits<double>::infinity();  ///< mm
};

/// Thresholds: a tetrahedron that varies by more is not brought below by moves and swaps.
inline constexpr double kBeyondMoves = 2.0;

/// What can be asked for of elements that may be `anisotropy` times longer across the gradient than along it.
QualityGoal quality_goal(double anisotropy);

/// How far a tetrahedron is from its goals: 1 where every one of them is met, less by the ratio to the goal
/// that it misses most. Negative, and the lower the more it is turned over, where it is not positively
/// oriented. Angles and material count alike, so that one acceptance test serves both.
class TetScore {
 public:
  TetScore(const MeshState& state, const QualityGoal& goal);

  double operator()(const std::array<int, 4>& v) const {
    const auto& x = state_.vertices;
    return of(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
  }
  double operator()(int t) const { return (*this)(state_.complex.tet(t).vertex); }

  /// The same with vertex `v` imagined at another place.
  double with(int t, int v, const Vertex& moved) const {
    const std::array<int, 4>& index = state_.complex.tet(t).vertex;
    const auto pick = [&](int i) -> const Vertex& {
      return index[i] == v ? moved : state_.vertices[index[i]];
    };
    return of(pick(0), pick(1), pick(2), pick(3));
  }

  double of(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) const;

  const QualityGoal& goal() const { return goal_; }

 private:
  const MeshState& state_;
  QualityGoal goal_;
  // Beyond these cosines an angle misses its goal.
  double cosine_of_smallest_, cosine_of_largest_;
};

}  // namespace fgmesh
