// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/swap.hpp"

namespace fgmesh {
namespace {

/// A swap must gain at least this part of the cost, or rounding makes swaps go in circles.
constexpr double kLeastGain = 1e-9;

bool is_gain(double before, double after) {
  if (std::isinf(before)) return after < before;
  return after < before - kLeastGain * std::abs(before);
}

/// Whether the vertices of the tetrahedron, listed in this order, turn the same way as in its own. Told by
/// the order alone, so that it is right for a tetrahedron that is flat or turned over, too.
bool same_sense(const Tet& tet, const std::array<int, 4>& order) {
  bool even = true;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) even ^= tet.index_of(order[i]) > tet.index_of(order[j]);
  return even;
}

}  // namespace

double Swapper::cost_of(int t) {
  if (!costs_ || t >= static_cast<int>(costs_->size())) return objective_.cost(state_.complex.tet(t).vertex);
  double& known = (*costs_)[t];
  if (std::isnan(known)) known = objective_.cost(state_.complex.tet(t).vertex);
  return known;
}

bool Swapper::replace(const std::vector<int>& cavity, const std::vector<LabelledFacet>& facets) {
  if (!state_.may_be_made(filling_, cavity)) return false;
  if (!state_.complex.replace(cavity, filling_, facets, site_)) return false;
  if (!costs_) return true;
  for (int t : site_.created())
    if (t < static_cast<int>(costs_->size())) (*costs_)[t] = std::numeric_limits<double>::quiet_NaN();
  return true;
}

bool Swapper::remove_ringed_edge(int a, int b) {
  TetComplex& complex = state_.complex;
  const int n = static_cast<int>(ring_.link.size());
  if (n > kLargestRing) return false;

  const int solid = complex.tet(ring_.tet.front()).solid;
  double before = -std::numeric_limits<double>::infinity();
  for (int around : ring_.tet) {
    const Tet& tet = complex.tet(around);
    if (tet.solid != solid) return remove_interface_edge(a, b);
    const double cost = cost_of(around);
    before = around == ring_.tet.front() ? cost : objective_.join(before, cost);
  }
  int label = 0;
  if (ring_.closed) {
    if (complex.crease(a, b) || state_.label_at(a, b, ring_)) return false;
  } else {
    const auto facet_label = [&](int tet_index, int apex) {
      const Tet& tet = complex.tet(tet_index);
      for (int i = 0; i < 4; ++i)
        if (tet.vertex[i] != a && tet.vertex[i] != b && tet.vertex[i] != apex) return tet.label[i];
      return 0;
    };
    label = facet_label(ring_.tet.front(), ring_.link.front());
    if (complex.crease(a, b) || label != facet_label(ring_.tet.back(), ring_.link.back())) return false;
  }

  const std::vector<int>& link = ring_.link;
  if (!same_sense(complex.tet(ring_.tet[0]), {a, b, link[0], link[1]})) std::swap(a, b);
  const double after = best_filling(0, n - 1, a, b);
  if (!is_gain(before, after) || !polygon_is_free()) return false;

  std::vector<LabelledFacet> facets;
  if (!ring_.closed) {
    if (!surface_allows(a, b, link.front(), link.back(), label)) return false;
    facets = {{{a, link.front(), link.back()}, label}, {{b, link.front(), link.back()}, label}};
  }
  filling_.clear();
  fill_polygon(0, n - 1, a, b, solid);
  return replace(ring_.tet, facets);
}

double Swapper::best_filling(int from, int to, int a, int b) {
  // The best triangulation of the polygon of link vertices, each triangle making two tetrahedra.
  const std::vector<int>& link = ring_.link;
  if (to == from + 1) return objective_.nothing();
  for (int i = from; i < to; ++i) best_[i][i + 1] = 0.0;
  for (int width = 2; width <= to - from; ++width) {
    for (int i = from; i + width <= to; ++i) {
      const int j = i + width;
      best_[i][j] = std::numeric_limits<double>::infinity();
      for (int k = i + 1; k < j; ++k) {
        double cost = objective_.cost({link[i], link[k], link[j], b});
        if (!(cost < std::numeric_limits<double>::infinity())) continue;
        cost = objective_.join(cost, objective_.cost({link[i], link[j], link[k], a}));
        if (k > i + 1) cost = objective_.join(cost, best_[i][k]);
        if (j > k + 1) cost = objective_.join(cost, best_[k][j]);
        if (cost < best_[i][j]) {
          best_[i][j] = cost;
          split_[i][j] = k;
        }
      }
    }
  }
  return best_[from][to];
}

bool Swapper::remove_interface_edge(int a, int b) {
  TetComplex& complex = state_.complex;
  const int n = static_cast<int>(ring_.tet.size());
  if (!ring_.closed || complex.crease(a, b)) return false;
  // The two facets of the interface at the edge: facet i stands before tetrahedron i, at link i.
  std::vector<int> facets, labels;
  double before = cost_of(ring_.tet.front());
  for (int i = 0; i < n; ++i) {
    const Tet& tet = complex.tet(ring_.tet[i]);
    if (i > 0) before = objective_.join(before, cost_of(ring_.tet[i]));
    const int label = tet.label[tet.index_of(ring_.link[(i + 1) % n])];
    if (!label) continue;
    facets.push_back(i);
    labels.push_back(label);
  }
  if (facets.size() != 2 || labels[0] != labels[1]) return false;
  std::rotate(ring_.tet.begin(), ring_.tet.begin() + facets[0], ring_.tet.end());
  std::rotate(ring_.link.begin(), ring_.link.begin() + facets[0], ring_.link.end());
  ring_.link.push_back(ring_.link.front());
  const int middle = facets[1] - facets[0];
  const std::vector<int>& link = ring_.link;
  const int c = link[0], d = link[middle], label = labels[0];
  const int first_solid = complex.tet(ring_.tet[0]).solid,
            second_solid = complex.tet(ring_.tet[middle]).solid;
  if (!same_sense(complex.tet(ring_.tet[0]), {a, b, c, link[1]})) std::swap(a, b);

  const double after = objective_.join(best_filling(0, middle, a, b), best_filling(middle, n, a, b));
  if (!is_gain(before, after)) return false;
  if (!half_is_free(0, middle, middle + 1 == n) || !half_is_free(middle, n, middle == 1)) return false;
  // Normals look out of the solid with the lower number.
  const bool first_is_lower = first_solid < second_solid;
  if (!surface_allows(a, b, first_is_lower ? c : d, first_is_lower ? d : c, label)) return false;
  filling_.clear();
  fill_polygon(0, middle, a, b, first_solid);
  fill_polygon(middle, n, a, b, second_solid);
  return replace(ring_.tet, {{{a, c, d}, label}, {{b, c, d}, label}});
}

/// Whether the edges that fill a part of the ring of an interface edge are new. `other_is_flat`: the other
/// part is one tetrahedron, which goes over to this one's solid, and its edge opposite becomes an interface
/// edge.
bool Swapper::half_is_free(int from, int to, bool other_is_flat) const {
  const std::vector<int>& link = ring_.link;
  if (to == from + 1) {
    EdgeRing opposite;
    state_.complex.ring(link[from], link[to], ring_.tet[from], opposite);
    return opposite.closed && !state_.label_at(link[from], link[to], opposite);
  }
  if (other_is_flat && to == from + 2 && exists(link[from], link[from + 1], link[to])) return false;
  for (int i = from; i <= to; ++i)
    for (int j = i + 2; j <= to; ++j)
      if (!(other_is_flat && i == from && j == to) && exists(link[i], link[j])) return false;
  return true;
}

void Swapper::fill_polygon(int i, int j, int a, int b, int solid) {
  if (j < i + 2) return;
  const int k = split_[i][j];
  const std::vector<int>& link = ring_.link;
  filling_.push_back({{link[i], link[k], link[j], b}, solid});
  filling_.push_back({{link[i], link[j], link[k], a}, solid});
  fill_polygon(i, k, a, b, solid);
  fill_polygon(k, j, a, b, solid);
}

bool Swapper::exists(int a, int b, int c) const {
  // Only where all lie on the boundary can a swap make again what stands elsewhere.
  for (int v : {a, b, c})
    if (v >= 0 && state_.vertices[v].carrier.dimension == 3) return false;
  state_.complex.star(a, star_);
  return std::any_of(star_.begin(), star_.end(), [&](int t) {
    const Tet& tet = state_.complex.tet(t);
    return tet.has(b) && (c < 0 || tet.has(c));
  });
}

bool Swapper::polygon_is_free() const {
  const std::vector<int>& link = ring_.link;
  const int n = static_cast<int>(link.size());
  if (n == 2) {  // a tetrahedron is taken away: the edge opposite must lie inside, and so must its faces
    EdgeRing opposite;
    state_.complex.ring(link[0], link[1], ring_.tet.front(), opposite);
    return opposite.closed && !state_.label_at(link[0], link[1], opposite);
  }
  if (n == 3 && ring_.closed) return !exists(link[0], link[1], link[2]);
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n; ++j)
      if (!(ring_.closed && i == 0 && j == n - 1) && exists(link[i], link[j])) return false;
  return true;
}

bool Swapper::surface_allows(int a, int b, int c, int d, int label) const {
  const Vertex &va = state_.vertices[a], &vb = state_.vertices[b], &vc = state_.vertices[c],
               &vd = state_.vertices[d];
  // The two diagonals of a symmetric quadrilateral are equally good: rounding must not tell them apart.
  constexpr double kSlack = 1.05;
  const double allowed = std::max(allowed_chord_error(state_, vc, vd), chord_error(state_, va, vb, label));
  if (chord_error(state_, vc, vd, label) > kSlack * allowed) return false;
  // Seen along a -> b the ring turns from c to d through the solid, so these look outward.
  return faces_outward(state_, va, vc, vd, label) && faces_outward(state_, vb, vd, vc, label);
}

bool Swapper::remove_face(int t, int face) {
  TetComplex& complex = state_.complex;
  const Tet& tet = complex.tet(t);
  const int other = tet.neighbour[face];
  if (other < 0 || tet.label[face]) return false;
  const Tet& beyond = complex.tet(other);
  const int p = tet.vertex[kFaceVertices[face][0]], q = tet.vertex[kFaceVertices[face][1]],
            r = tet.vertex[kFaceVertices[face][2]];
  int far = -1;
  for (int v : beyond.vertex)
    if (v != p && v != q && v != r) far = v;
  const int near = tet.vertex[face];
  const double before = objective_.join(cost_of(t), cost_of(other));
  const std::array<std::array<int, 4>, 3> made = {{{near, far, p, q}, {near, far, q, r}, {near, far, r, p}}};
  double after = objective_.cost(made[0]);
  for (int i = 1; i < 3 && is_gain(before, after); ++i)
    after = objective_.join(after, objective_.cost(made[i]));
  if (!is_gain(before, after)) return false;
  if (exists(near, far)) return false;
  const int solid = tet.solid;
  filling_.clear();
  for (const auto& vertex : made) filling_.push_back({vertex, solid});
  return replace({t, other}, {});
}

bool Swapper::improve(int t) {
  for (int face = 0; face < 4; ++face)
    if (remove_face(t, face)) return true;
  const std::array<int, 4> v = state_.complex.tet(t).vertex;
  for (const auto& edge : kEdgeVertices)
    if (remove_edge(v[edge[0]], v[edge[1]], t)) return true;
  return false;
}

}  // namespace fgmesh
