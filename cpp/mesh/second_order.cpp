// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/second_order.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "quality/curved_tets.hpp"
#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

/// Smallest Jacobian determinant of a curved tetrahedron, as part of that of the straight one.
constexpr double kLeastJacobian = 0.1;

/// Offsets below this part of the edge are rounding.
constexpr double kStraight = 1e-12;

using Edge = std::array<std::int32_t, 2>;

Edge sorted(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// The node in the middle of an edge.
struct Middle {
  Vec3 chord = Vec3::Zero();   ///< halfway between the ends
  Vec3 offset = Vec3::Zero();  ///< from there to the true boundary
  double part = 1.0;           ///< of the offset that is kept
  Carrier carrier;             ///< what the edge follows
  std::int32_t solid = 1;      ///< SolidN of a tetrahedron at the edge

  Vec3 place() const { return chord + part * offset; }
  bool curved() const { return part * offset.squaredNorm() > 0.0; }
  double flatter() const { return part > 0.5 ? 0.5 : 0.0; }
};

class OrderRaiser {
 public:
  explicit OrderRaiser(const TetMesh& mesh) : mesh_(mesh) {
    edges_.reserve(6 * mesh.tets.size());
    for (const auto& tet : mesh.tets)
      for (const auto& [i, j] : kMiddleEdges) edges_.push_back(sorted(tet[i], tet[j]));
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    middles_.resize(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e)
      middles_[e].chord = 0.5 * (mesh.points[edges_[e][0]] + mesh.points[edges_[e][1]]);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      tet_edges_.emplace_back();
      for (int k = 0; k < 6; ++k) {
        const int e = number(mesh.tets[t][kMiddleEdges[k][0]], mesh.tets[t][kMiddleEdges[k][1]]);
        tet_edges_[t][k] = e;
        middles_[e].solid = mesh.tet_solids[t];
        middles_[e].carrier = {3, mesh.tet_solids[t]};
      }
    }
  }

  /// Brings the nodes of boundary edges onto the true boundary.
  void project(const BoundaryGeometry& boundary, RunControl& control) {
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh_.triangles[i];
      for (const int e : {number(a, b), number(b, c), number(c, a)})
        middles_[e].carrier = {2, mesh_.triangle_faces[i]};
    }
    for (std::size_t i = 0; i < mesh_.edges.size(); ++i)
      middles_[number(mesh_.edges[i][0], mesh_.edges[i][1])].carrier = {1, mesh_.edge_edges[i]};
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      control.check();
      Middle& middle = middles_[e];
      const auto [dimension, carrier] = middle.carrier;
      if (dimension == 3) continue;
      middle.offset = (dimension == 1 ? boundary.project_to_edge(carrier, middle.chord).position
                                      : boundary.project_to_face(carrier, middle.chord).position) -
                      middle.chord;
      const double length = (mesh_.points[edges_[e][0]] - mesh_.points[edges_[e][1]]).norm();
      if (!(middle.offset.norm() > kStraight * length)) middle.offset.setZero();
    }
  }

  /// Flattens edges until every tetrahedron is proved valid. It ends, since straight tetrahedra are.
  void flatten(RunControl& control) {
    std::vector<char> changed(edges_.size(), 1);
    bool any = true;
    while (any) {
      any = false;
      std::vector<char> flattened(edges_.size(), 0);
      for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
        control.check();
        const auto& edges = tet_edges_[t];
        if (std::none_of(edges.begin(), edges.end(), [&](int e) { return changed[e] || flattened[e]; }))
          continue;
        for (int e = edge_to_flatten(t); e >= 0; e = edge_to_flatten(t)) {
          middles_[e].part = middles_[e].flatter();
          flattened[e] = any = true;
        }
      }
      changed.swap(flattened);
    }
  }

  SecondOrderMesh finished() const {
    const auto first = static_cast<std::int32_t>(mesh_.points.size());
    SecondOrderMesh result{mesh_.points, mesh_.carriers, {}, {}, {}, {}};
    for (const Middle& middle : middles_) {
      const bool off = middle.part < 1.0;
      if (off) result.straightened.push_back(static_cast<std::int32_t>(result.points.size()));
      result.points.push_back(middle.place());
      result.carriers.push_back(off ? Carrier{3, middle.solid} : middle.carrier);
    }
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      auto& row = result.tets.emplace_back();
      std::copy(mesh_.tets[t].begin(), mesh_.tets[t].end(), row.begin());
      for (int k = 0; k < 6; ++k) row[4 + k] = first + tet_edges_[t][k];
    }
    for (const auto& [a, b, c] : mesh_.triangles)
      result.triangles.push_back({a, b, c, first + number(a, b), first + number(b, c), first + number(c, a)});
    for (const auto& [a, b] : mesh_.edges) result.edges.push_back({a, b, first + number(a, b)});
    return result;
  }

 private:
  int number(std::int32_t a, std::int32_t b) const {
    return static_cast<int>(std::lower_bound(edges_.begin(), edges_.end(), sorted(a, b)) - edges_.begin());
  }

  CurvedTet nodes_of(std::size_t t) const {
    CurvedTet nodes;
    for (int i = 0; i < 4; ++i) nodes[i] = mesh_.points[mesh_.tets[t][i]];
    for (int k = 0; k < 6; ++k) nodes[4 + k] = middles_[tet_edges_[t][k]].place();
    return nodes;
  }

  /// The edge of a tetrahedron whose flattening serves it best; -1 where it is valid as it is.
  int edge_to_flatten(std::size_t t) const {
    const auto& edges = tet_edges_[t];
    if (std::none_of(edges.begin(), edges.end(), [&](int e) { return middles_[e].curved(); })) return -1;
    CurvedTet nodes = nodes_of(t);
    if (jacobian_is_above(nodes, kLeastJacobian * orientation(nodes[0], nodes[1], nodes[2], nodes[3])))
      return -1;
    int best = -1;
    double best_jacobian = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < 6; ++k) {
      Middle middle = middles_[edges[k]];
      if (!middle.curved()) continue;
      middle.part = middle.flatter();
      const Vec3 before = std::exchange(nodes[4 + k], middle.place());
      const auto jacobian = jacobian_coefficients(nodes);
      const double least = *std::min_element(jacobian.begin(), jacobian.end());
      nodes[4 + k] = before;
      if (best >= 0 && least <= best_jacobian) continue;
      best = edges[k];
      best_jacobian = least;
    }
    return best;
  }

  const TetMesh& mesh_;
  std::vector<Edge> edges_;                    ///< each once, sorted
  std::vector<Middle> middles_;                ///< of each edge
  std::vector<std::array<int, 6>> tet_edges_;  ///< in the order of kMiddleEdges
};

}  // namespace

SecondOrderMesh make_second_order(const TetMesh& mesh, const BoundaryGeometry& boundary,
                                  RunControl& control) {
  OrderRaiser raiser(mesh);
  raiser.project(boundary, control);
  raiser.flatten(control);
  return raiser.finished();
}

}  // namespace fgmesh
