// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary_recovery.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <sstream>

#include "core/error.hpp"
#include "domain/cgal_types.hpp"
#include "mesh/slot_set.hpp"
#include "mesh/surface_remeshing.hpp"
#include "mesh/swap.hpp"

namespace fgmesh {
namespace {

constexpr int kHull = 1 << 30;  // label of the hull of the triangulation
constexpr int kKept = 1 << 30;  // "crease" of a recovered edge inside a face

constexpr int kPoll = 256;  // elements between two looks at the control

using Edge = std::array<int, 2>;

using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<int, CgalKernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<CgalKernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<CgalKernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

/// How many tetrahedra a segment runs through, but those that have it as an edge. Swaps that lower it bring
/// the segment about.
class ThroughSegment final : public SwapObjective {
 public:
  ThroughSegment(const MeshState& state, int a, int b) : state_(state), a_(a), b_(b) {}
  double cost(const std::array<int, 4>& v) const override {
    if (!is_positive(state_.position(v[0]), state_.position(v[1]), state_.position(v[2]),
                     state_.position(v[3])))
      return std::numeric_limits<double>::infinity();
    return meets(v) ? 1.0 : 0.0;
  }
  bool meets(const std::array<int, 4>& v) const {
    const bool has_a = std::find(v.begin(), v.end(), a_) != v.end();
    if (has_a && std::find(v.begin(), v.end(), b_) != v.end()) return false;
    // The part of the segment on the inner side of all four faces.
    constexpr double kOnFace = 1e-6, kLeastPart = 1e-5;
    const Vec3 &p = state_.position(a_), &q = state_.position(b_);
    double from = 0.0, to = 1.0;
    // By the box first: a flat tetrahedron has no inner side.
    Box box{state_.position(v[0]), state_.position(v[0])};
    for (int i = 1; i < 4; ++i) {
      box.low = box.low.cwiseMin(state_.position(v[i]));
      box.high = box.high.cwiseMax(state_.position(v[i]));
    }
    const double margin = kOnFace * (q - p).norm();
    for (int axis = 0; axis < 3; ++axis) {
      const double start = p[axis], way = q[axis] - p[axis];
      const double low = box.low[axis] - margin, high = box.high[axis] + margin;
      if (std::abs(way) <= margin) {
        if (start < low || start > high) return false;
        continue;
      }
      const double at_low = (low - start) / way, at_high = (high - start) / way;
      from = std::max(from, std::min(at_low, at_high));
      to = std::min(to, std::max(at_low, at_high));
    }
    if (to - from <= kLeastPart) return false;
    for (int i = 0; i < 4; ++i) {
      const Vec3& corner = state_.position(v[kFaceVertices[i][0]]);
      const Vec3 outward = area_vector(corner, state_.position(v[kFaceVertices[i][1]]),
                                       state_.position(v[kFaceVertices[i][2]]))
                               .normalized();
      const double at_p = outward.dot(p - corner) - margin, at_q = outward.dot(q - corner) - margin;
      if (at_p > 0.0 && at_q > 0.0) return false;
      if (at_p > 0.0) from = std::max(from, at_p / (at_p - at_q));
      if (at_q > 0.0) to = std::min(to, at_p / (at_p - at_q));
    }
    return to - from > kLeastPart;
  }
  double join(double a, double b) const override { return a + b; }
  double nothing() const override { return std::numeric_limits<double>::infinity(); }

 private:
  const MeshState& state_;
  int a_, b_;
};

/// How many edges of the tetrahedra pierce a triangle.
class ThroughTriangle final : public SwapObjective {
 public:
  ThroughTriangle(const MeshState& state, const std::array<int, 3>& triangle)
      : state_(state), triangle_(triangle) {}
  double cost(const std::array<int, 4>& v) const override {
    if (!is_positive(state_.position(v[0]), state_.position(v[1]), state_.position(v[2]),
                     state_.position(v[3])))
      return std::numeric_limits<double>::infinity();
    return piercing(v);
  }
  int piercing(const std::array<int, 4>& v) const {
    int count = 0;
    for (const auto& [i, j] : kEdgeVertices) count += pierces(v[i], v[j]);
    return count;
  }
  double join(double a, double b) const override { return a + b; }
  double nothing() const override { return std::numeric_limits<double>::infinity(); }

 private:
  bool pierces(int p, int q) const {
    for (int corner : triangle_)
      if (p == corner || q == corner) return false;
    const Vec3 &a = state_.position(triangle_[0]), &b = state_.position(triangle_[1]),
               &c = state_.position(triangle_[2]), &from = state_.position(p), &to = state_.position(q);
    const double below = orientation(a, b, c, from), above = orientation(a, b, c, to);
    if ((below > 0.0) == (above > 0.0)) return false;
    const double x = orientation(from, to, a, b), y = orientation(from, to, b, c),
                 z = orientation(from, to, c, a);
    return (x > 0.0 && y > 0.0 && z > 0.0) || (x < 0.0 && y < 0.0 && z < 0.0);
  }

  const MeshState& state_;
  std::array<int, 3> triangle_;
};

class Recovery {
 public:
  Recovery(MeshState& state, SurfaceMesh& surface, RunControl& control)
      : state_(state), surface_(surface), control_(control) {}

  void run() {
    add_box();
    constexpr int kMostRounds = 30, kLargestGrowth = 20;
    std::size_t most = 0, left = 0;  // triangles; edges or triangles that were missing
    for (int round = 0; round < kMostRounds; ++round) {
      control_.check();
      rebuild();
      const std::size_t triangles = triangles_.size();
      if (round == 0) most = kLargestGrowth * triangles;
      std::vector<Edge> missing = missing_edges();
      if (missing.empty()) missing = missing_triangles();
      if (missing.empty()) {
        keep_solids();
        return;
      }
      const bool diverges = triangles > most && missing.size() > left;
      if (round + 1 == kMostRounds || diverges) refuse(missing.front());
      left = missing.size();
      for (const auto& [a, b] : missing)
        if (surface_.split(a, b) < 0) split_beside(a, b);
      make_surface_delaunay(surface_, control_);
    }
  }

 private:
  /// Splits the longest crease edge of the triangles at (a, b): across a narrow bent strip the edge leaves
  /// its face unless the strip's borders are fine.
  void split_beside(int a, int b) {
    std::vector<int> around;
    surface_.at_edge(a, b, around);
    Edge longest = {-1, -1};
    double length = 0.0;
    for (int t : around) {
      const std::array<int, 3>& v = surface_.triangles[t].vertex;
      for (int i = 0; i < 3; ++i) {
        const int p = v[i], q = v[(i + 1) % 3];
        const double own = (surface_.position(p) - surface_.position(q)).norm();
        if (!surface_.crease(p, q) || own <= length) continue;
        length = own;
        longest = {p, q};
      }
    }
    if (longest[0] >= 0) surface_.split(longest[0], longest[1]);
  }

  [[noreturn]] void refuse(const Edge& edge) const {
    std::ostringstream text;
    text << "the boundary cannot be recovered at " << Shown{state_.position(edge[0])}
         << " mm: faces cut or touch each other there, or are closer than the elements are long; lower "
            "MaxSize";
    throw GeometryError(text.str());
  }

  /// Far corners, so that everything else lies inside the triangulation.
  void add_box() {
    Box box{surface_.position(0), surface_.position(0)};
    for (const Vertex& vertex : surface_.vertices) {
      box.low = box.low.cwiseMin(vertex.position);
      box.high = box.high.cwiseMax(vertex.position);
    }
    const Vec3 margin = Vec3::Constant(box.diagonal());
    box_ = {box.low - margin, box.high + margin};
    for (int corner = 0; corner < 8; ++corner) {
      Vertex vertex;
      for (int i = 0; i < 3; ++i) vertex.position[i] = corner >> i & 1 ? box_.high[i] : box_.low[i];
      insert(surface_.add_vertex(vertex));
    }
    for (int v = 0; v < static_cast<int>(surface_.vertices.size()); ++v)
      if (!surface_.at(v).empty()) insert(v);
    inserted_ = static_cast<int>(surface_.vertices.size());
  }

  void insert(int v) {
    if (v % kPoll == 0) control_.check_at(surface_.position(v));
    const auto before = delaunay_.number_of_vertices();
    const auto made = delaunay_.insert(to_cgal(surface_.position(v)), hint_);
    if (delaunay_.number_of_vertices() == before) {
      std::ostringstream text;
      text << "two vertices of the boundary are at the same place, " << Shown{surface_.position(v)} << " mm";
      throw GeometryError(text.str());
    }
    made->info() = v;
    hint_ = made->cell();
  }

  /// The Delaunay triangulation of all vertices, nothing recovered.
  void rebuild() {
    for (; inserted_ < static_cast<int>(surface_.vertices.size()); ++inserted_) insert(inserted_);
    state_.vertices = surface_.vertices;
    std::vector<NewTet> tets;
    std::vector<LabelledFacet> hull;
    for (auto cell = delaunay_.finite_cells_begin(); cell != delaunay_.finite_cells_end(); ++cell) {
      NewTet tet{{}, 1};
      for (int i = 0; i < 4; ++i) tet.vertex[i] = cell->vertex(i)->info();
      tets.push_back(tet);
      for (int i = 0; i < 4; ++i)
        if (delaunay_.is_infinite(cell->neighbor(i)))
          hull.push_back(
              {{tet.vertex[(i + 1) % 4], tet.vertex[(i + 2) % 4], tet.vertex[(i + 3) % 4]}, kHull});
    }
    state_.complex.build(tets, hull, static_cast<int>(state_.vertices.size()));
    for (const LabelledFacet& facet : hull)
      for (int i = 0; i < 3; ++i)
        state_.complex.set_crease(facet.vertex[i], facet.vertex[(i + 1) % 3], kKept);
    triangles_.clear();
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t)
      if (surface_.triangles[t].alive()) triangles_.push_back(static_cast<int>(t));
  }

  /// Swaps along tetrahedra that cost something, from those at vertex `from` on, until `found` or no swap
  /// helps.
  template <class Costs, class Found>
  bool swap_until(int from, Swapper& swapper, const Costs& costs, const Found& found) {
    constexpr std::size_t kLongestWalk = 300;
    std::vector<int> queue;
    while (!found()) {
      state_.complex.star(from, queue);
      queue.erase(std::remove_if(queue.begin(), queue.end(), [&](int t) { return !costs(t); }), queue.end());
      SlotSet met;
      for (int t : queue) met.insert(t);
      bool swapped = false;
      for (std::size_t next = 0; next < queue.size() && !swapped && queue.size() < kLongestWalk; ++next) {
        const Tet tet = state_.complex.tet(queue[next]);
        for (int other : tet.neighbour)
          if (other >= 0 && !met.contains(other) && costs(other)) {
            met.insert(other);
            queue.push_back(other);
          }
      }
      for (std::size_t next = 0; next < queue.size() && !swapped; ++next)
        swapped = swapper.improve(queue[next]);
      if (!swapped) return false;
    }
    return true;
  }

  bool recover_edge(int a, int b) {
    const ThroughSegment objective(state_, a, b);
    Swapper swapper(state_, objective);
    return swap_until(
        a, swapper, [&](int t) { return objective.meets(state_.complex.tet(t).vertex); },
        [&] { return state_.complex.find_edge(a, b) >= 0; });
  }

  /// A tetrahedron and its face on the triangle; {-1, -1} where there is none.
  std::array<int, 2> find_face(const std::array<int, 3>& v) {
    state_.complex.star(v[0], star_);
    for (int t : star_) {
      const Tet& tet = state_.complex.tet(t);
      if (!tet.has(v[1]) || !tet.has(v[2])) continue;
      for (int i = 0; i < 4; ++i)
        if (tet.vertex[i] != v[0] && tet.vertex[i] != v[1] && tet.vertex[i] != v[2]) return {t, i};
    }
    return {-1, -1};
  }

  bool recover_triangle(const std::array<int, 3>& v) {
    const ThroughTriangle objective(state_, v);
    Swapper swapper(state_, objective);
    return swap_until(
        v[0], swapper, [&](int t) { return objective.piercing(state_.complex.tet(t).vertex) > 0; },
        [&] { return find_face(v)[0] >= 0; });
  }

  std::vector<Edge> missing_edges() {
    std::vector<Edge> missing;
    for (int t : triangles_) {
      const SurfaceTriangle triangle = surface_.triangles[t];
      if (t % kPoll == 0) control_.check_at(surface_.position(triangle.vertex[0]));
      if (!triangle.alive()) continue;
      for (int i = 0; i < 3; ++i) {
        const int a = triangle.vertex[i], b = triangle.vertex[(i + 1) % 3];
        if (state_.complex.crease(a, b)) continue;  // recovered for the triangle on its other side
        if (recover_edge(a, b)) {
          const int edge = surface_.crease(a, b);
          state_.complex.set_crease(a, b, edge ? edge : kKept);
        } else {
          missing.push_back({std::min(a, b), std::max(a, b)});
        }
      }
    }
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    return missing;
  }

  std::vector<Edge> missing_triangles() {
    std::vector<Edge> missing;
    std::vector<int> left;
    for (int t : triangles_) {
      const SurfaceTriangle triangle = surface_.triangles[t];
      if (t % kPoll == 0) control_.check_at(surface_.position(triangle.vertex[0]));
      if (!triangle.alive()) continue;
      if (recover_triangle(triangle.vertex)) {
        const auto [tet, face] = find_face(triangle.vertex);
        state_.complex.set_label(tet, face, triangle.face);
        continue;
      }
      left.push_back(t);
      Edge longest{};
      double length = 0.0;
      for (int i = 0; i < 3; ++i) {
        const int a = triangle.vertex[i], b = triangle.vertex[(i + 1) % 3];
        const double own = (state_.position(a) - state_.position(b)).norm();
        if (own <= length) continue;
        length = own;
        longest = {std::min(a, b), std::max(a, b)};
      }
      missing.push_back(longest);
    }
    triangles_ = left;
    std::sort(missing.begin(), missing.end());
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    return missing;
  }

  /// Leaves the tetrahedra inside the solids, their facets and creases.
  void keep_solids() {
    const TetComplex& complex = state_.complex;
    std::vector<int> solid(complex.slots(), -1), queue;
    std::vector<LabelledFacet> facets;
    for (const SurfaceTriangle& triangle : surface_.triangles) {
      if (!triangle.alive()) continue;
      facets.push_back({triangle.vertex, triangle.face});
      const auto [t, face] = find_face(triangle.vertex);
      if (t < 0) refuse({triangle.vertex[0], triangle.vertex[1]});
      // Behind the triangle, where it looks out of the tetrahedron.
      const bool behind = is_outward(complex.tet(t), face, triangle.vertex);
      const int other = complex.tet(t).neighbour[face];
      for (const auto& [tet, own] :
           {std::pair(t, triangle.solid[behind ? 0 : 1]), std::pair(other, triangle.solid[behind ? 1 : 0])}) {
        if (tet < 0) continue;
        if (solid[tet] < 0) queue.push_back(tet);
        if (solid[tet] >= 0 && solid[tet] != own) refuse({triangle.vertex[0], triangle.vertex[1]});
        solid[tet] = own;
      }
    }
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const Tet& tet = complex.tet(queue[next]);
      for (int i = 0; i < 4; ++i) {
        const int other = tet.neighbour[i];
        if (other < 0 || tet.label[i]) continue;
        if (solid[other] < 0) {
          solid[other] = solid[queue[next]];
          queue.push_back(other);
        } else if (solid[other] != solid[queue[next]]) {
          refuse({tet.vertex[0], tet.vertex[1]});
        }
      }
    }
    std::vector<NewTet> tets;
    for (int t = 0; t < complex.slots(); ++t)
      if (complex.tet(t).alive() && solid[t] > 0) tets.push_back({complex.tet(t).vertex, solid[t]});
    state_.complex.build(tets, facets, static_cast<int>(state_.vertices.size()));
    for (const auto& [key, edge] : surface_.creases()) {
      const auto [a, b] = SurfaceMesh::ends(key);
      state_.complex.set_crease(a, b, edge);
    }
  }

  static bool is_outward(const Tet& tet, int face, const std::array<int, 3>& v) {
    const int* k = kFaceVertices[face];
    for (int turn = 0; turn < 3; ++turn)
      if (tet.vertex[k[0]] == v[turn] && tet.vertex[k[1]] == v[(turn + 1) % 3]) return true;
    return false;
  }

  MeshState& state_;
  SurfaceMesh& surface_;
  RunControl& control_;
  Box box_;
  Delaunay delaunay_;
  Delaunay::Cell_handle hint_;
  int inserted_ = 0;            // vertices of the surface that are in the triangulation
  std::vector<int> triangles_;  // not known to be there yet
  std::vector<int> star_;
};

}  // namespace

void tetrahedralize(MeshState& state, SurfaceMesh& surface, RunControl& control) {
  Recovery(state, surface, control).run();
}

}  // namespace fgmesh
