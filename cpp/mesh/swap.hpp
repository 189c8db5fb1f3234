// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "mesh/mesh_state.hpp"
#include "mesh/stretch.hpp"
#include "mesh/tet_score.hpp"

namespace fgmesh {

/// What swaps lower. cost() of a tetrahedron is infinite where it is not positively oriented; join() puts the
/// costs of two sets of tetrahedra together.
class SwapObjective {
 public:
  virtual ~SwapObjective() = default;
  virtual double cost(const std::array<int, 4>& tet) const = 0;
  virtual double join(double a, double b) const = 0;
  /// Of no tetrahedron at all: what is left where a flat one on the boundary is taken away.
  virtual double nothing() const = 0;
};

/// The ODT energy for fixed vertices: the interpolation error of |x|^2, sum of |T| times the squared edges
/// (Chen and Xu 2004), in the stretched space where elements are to be anisotropic. Its minimum is the
/// Delaunay triangulation, so lowering it by swaps leads there.
class OdtEnergy final : public SwapObjective {
 public:
  /// Tetrahedra that vary by more than `most_variation` are not made.
  explicit OdtEnergy(const MeshState& state, double most_variation = std::numeric_limits<double>::infinity())
      : state_(state), most_variation_(most_variation) {}
  double cost(const std::array<int, 4>& v) const override {
    const auto& x = state_.vertices;
    const StretchedTet tet(x[v[0]], x[v[1]], x[v[2]], x[v[3]]);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!(tet.flatness() > 1e-6)) return kInfinity;
    // Where any is allowed it is not looked at.
    if (most_variation_ < kInfinity && state_.variation(v) > most_variation_) return kInfinity;
    return tet.volume * tet.squared_edges;
  }
  double join(double a, double b) const override { return a + b; }
  double nothing() const override { return std::numeric_limits<double>::infinity(); }

 private:
  const MeshState& state_;
  double most_variation_;
};

/// The worst score of the tetrahedra.
class WorstScore final : public SwapObjective {
 public:
  explicit WorstScore(const TetScore& score) : score_(score) {}
  double cost(const std::array<int, 4>& v) const override {
    const double score = score_(v);
    return score < 0.0 ? std::numeric_limits<double>::infinity() : -score;
  }
  double join(double a, double b) const override { return std::max(a, b); }
  double nothing() const override { return -1.0; }

 private:
  const TetScore& score_;
};

/// Swaps edges and faces of a mesh where that lowers an objective. Creases and labels stay; an edge inside a
/// face of the boundary or of an interface is swapped with the surface (2-2) where the new edge stays as
/// close to the true face as allowed_chord_error() asks.
class Swapper {
 public:
  Swapper(MeshState& state, const SwapObjective& objective)
      : Swapper(state, objective, state.complex.own_site(), nullptr) {}
  /// One of several at the same time, see TetComplex::Site. `costs` keeps those of the tetrahedra that have
  /// an entry, NaN where not known yet, for as long as nothing moves.
  Swapper(MeshState& state, const SwapObjective& objective, TetComplex::Site& site,
          std::vector<double>* costs)
      : state_(state), objective_(objective), site_(site), costs_(costs) {}

  /// Removes the edge (a, b), which tetrahedron t has, if some other filling of its ring costs less.
  bool remove_edge(int a, int b, int t) {
    return state_.complex.small_ring(a, b, t, kLargestRing, ring_) && remove_ringed_edge(a, b);
  }
  /// The same where ring() is that of the edge already.
  bool remove_ringed_edge(int a, int b);
  EdgeRing& ring() { return ring_; }

  /// Exchanges the face that t shares with its neighbour for an edge, if the three new tetrahedra cost less.
  bool remove_face(int t, int face);

  /// Tries the edges and faces of one tetrahedron until one is swapped.
  bool improve(int t);

 private:
  double cost_of(int t);
  /// Replaces `cavity` by filling_.
  bool replace(const std::vector<int>& cavity, const std::vector<LabelledFacet>& facets);
  bool remove_interface_edge(int a, int b);
  double best_filling(int from, int to, int a, int b);
  bool surface_allows(int a, int b, int c, int d, int label) const;
  bool exists(int a, int b, int c = -1) const;
  bool polygon_is_free() const;
  bool half_is_free(int from, int to, bool other_is_flat) const;
  void fill_polygon(int i, int j, int a, int b, int solid);

  static constexpr int kLargestRing = 7;  // vertices

  MeshState& state_;
  const SwapObjective& objective_;
  TetComplex::Site& site_;
  std::vector<double>* costs_;

  EdgeRing ring_;
  double best_[kLargestRing + 1][kLargestRing + 1];
  int split_[kLargestRing + 1][kLargestRing + 1];
  std::vector<NewTet> filling_;
  mutable std::vector<int> star_;
};

}  // namespace fgmesh
