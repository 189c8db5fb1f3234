// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/crossing_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "mesh/triangle_crossings.hpp"

namespace fgmesh {
namespace {

/// Lengths as parts of the diagonal. Faces nearer than `kTouching` touch. Within `kBorder` of the borders of
/// both, faces may meet: neighbours do, and sloppy ones cross there within their tolerance.
constexpr double kTouching = 1e-7, kBorder = 1e-3;

constexpr double kTangent = 0.05;  // sine between normals

class CrossingSearch {
 public:
  CrossingSearch(const SampledBoundary& samples, const BoundaryGeometry& boundary, RunControl& control)
      : samples_(samples), boundary_(boundary), control_(control), diagonal_(samples.bounds.diagonal()) {
    triangles_at_.resize(samples.points.size());
    for (std::size_t t = 0; t < samples.triangles.size(); ++t)
      for (int v : samples.triangles[t]) triangles_at_[v].push_back(static_cast<int>(t));
    for (const SampledBoundary::Curve& curve : samples.curves)
      for (int face : curve.faces) edges_of_face_[face].push_back(curve.edge);
  }

  void run() {
    for (const SampledBoundary::Curve& curve : samples_.curves) look_along(curve);
    std::vector<int> all(samples_.triangles.size());
    for (std::size_t t = 0; t < all.size(); ++t) all[t] = static_cast<int>(t);
    for_each_crossing(
        all, [&](int t) -> const std::array<int, 3>& { return samples_.triangles[t]; },
        [&](int v) -> const Vec3& { return samples_.points[v]; }, [&](int t, int u) { look_at(t, u); });
  }

 private:
  /// A part of a face at an edge, as one solid has it.
  struct Side {
    int face;
    Vec3 away, outward;  ///< from the edge along the face, and out of the solid
  };

  /// A solid that has more than two faces at an edge touches itself there. Where two of these lie upon each
  /// other, it or the gap between them has no thickness.
  void look_along(const SampledBoundary::Curve& curve) {
    if (curve.faces.size() < 3) return;
    for (const auto& [solid, sides] : sides_at(curve))
      for (std::size_t i = 0; i < sides.size() && sides.size() > 2; ++i)
        for (std::size_t k = i + 1; k < sides.size(); ++k)
          if (sides[i].away.dot(sides[k].away) > 0.0 && sides[i].outward.dot(sides[k].outward) < 0.0 &&
              sides[i].outward.cross(sides[k].outward).norm() < kTangent)
            refuse_tangent(sides[i].face, sides[k].face, curve.edge);
  }

  /// Of each solid at the middle of an edge.
  std::map<int, std::vector<Side>> sides_at(const SampledBoundary::Curve& curve) const {
    const std::size_t half = curve.points.size() / 2;
    const int from = curve.points[half - 1], to = curve.points[half];
    const CurvePoint place =
        boundary_.project_to_edge(curve.edge, 0.5 * (samples_.points[from] + samples_.points[to]));
    std::map<int, std::vector<Side>> sides;
    for (int t : triangles_at_[from]) {
      const std::array<int, 3>& v = samples_.triangles[t];
      if (std::find(v.begin(), v.end(), to) == v.end()) continue;
      const int face = samples_.triangle_face[t];
      const Vec3 normal = boundary_.project_to_face(face, place.position).normal;
      Vec3 away = centre(t) - place.position;
      away -= away.dot(place.tangent) * place.tangent;
      away -= away.dot(normal) * normal;
      const auto& [behind, before] = samples_.triangle_solids[t];
      if (behind) sides[behind].push_back({face, away, normal});
      if (before) sides[before].push_back({face, away, -normal});
    }
    return sides;
  }

  void look_at(int t, int u) {
    control_.check_at(corner(t, 0));
    const int face = std::min(samples_.triangle_face[t], samples_.triangle_face[u]);
    const int other = std::max(samples_.triangle_face[t], samples_.triangle_face[u]);
    if (face == other) {
      // One pair may be a slip of the triangulation.
      constexpr int kFewest = 3;
      if (cuts_steeply(t, u) && ++looks_[{face, face}] == kFewest) refuse(face, face, crossing_point(t, u));
      return;
    }
    // Two thin walls may have very many samples that cut each other; a crossing shows in the first few.
    constexpr int kMostLooks = 200;
    if (++looks_[{face, other}] > kMostLooks) return;
    const std::optional<Vec3> meeting = meeting_point(face, other, crossing_point(t, u), size(t) + size(u));
    if (!meeting || (!have_common_solid(t, u) && are_tangent(face, other, *meeting))) return;
    const double margin = kBorder * diagonal_;
    if (border_distance(face, *meeting) > margin || border_distance(other, *meeting) > margin)
      refuse(face, other, *meeting);
  }

  bool have_common_solid(int t, int u) const {
    const auto &first = samples_.triangle_solids[t], &second = samples_.triangle_solids[u];
    return std::any_of(first.begin(), first.end(),
                       [&](int solid) { return solid && (solid == second[0] || solid == second[1]); });
  }

  /// Solids may touch at a point, as a ball does on a plane: their meshes stay just apart there. Within one
  /// solid that would be a wall without thickness.
  bool are_tangent(int face, int other, const Vec3& point) const {
    const Vec3 a = boundary_.project_to_face(face, point).normal,
               b = boundary_.project_to_face(other, point).normal;
    return a.cross(b).norm() < kTangent;
  }

  const Vec3& corner(int t, int i) const { return samples_.points[samples_.triangles[t][i % 3]]; }
  Vec3 centre(int t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0; }
  Vec3 normal(int t) const {
    return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
  }
  double size(int t) const {
    double longest = 0.0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, (corner(t, i + 1) - corner(t, i)).norm());
    return longest;
  }

  /// A point that both triangles have; of two in one plane, the centre of the smaller one.
  Vec3 crossing_point(int t, int u) const {
    Vec3 best = size(t) < size(u) ? centre(t) : centre(u);
    double depth = -std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : {std::pair{t, u}, std::pair{u, t}}) {
      const Vec3 n = normal(b);
      for (int i = 0; i < 3; ++i) {
        const Vec3 &from = corner(a, i), &to = corner(a, i + 1);
        const double start = n.dot(from - corner(b, 0)), end = n.dot(to - corner(b, 0));
        if (start * end > 0.0 || start == end) continue;
        const Vec3 point = from + start / (start - end) * (to - from);
        double inside = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
          const Vec3 side = corner(b, k + 1) - corner(b, k);
          inside = std::min(inside, n.dot(side.cross(point - corner(b, k))) / side.norm());
        }
        if (inside <= depth) continue;
        depth = inside;
        best = point;
      }
    }
    return best;
  }

  /// A point of both faces near `start`, by Newton's method on their tangent planes in steps of at most
  /// `reach`; nothing where they stay apart.
  std::optional<Vec3> meeting_point(int face, int other, const Vec3& start, double reach) const {
    constexpr int kMostSteps = 25;
    constexpr double kParallel = 1e-5;
    Vec3 point = start;
    for (int step = 0; step < kMostSteps; ++step) {
      const SurfacePoint a = boundary_.project_to_face(face, point);
      const SurfacePoint b = boundary_.project_to_face(other, a.position);
      if ((a.position - b.position).norm() <= kTouching * diagonal_) return a.position;
      point = 0.5 * (a.position + b.position);
      const double c = a.normal.dot(b.normal), sine = a.normal.cross(b.normal).norm();
      if (sine < kParallel) continue;
      const double p = a.normal.dot(a.position - point), q = b.normal.dot(b.position - point);
      const Vec3 move = ((p - c * q) * a.normal + (q - c * p) * b.normal) / (sine * sine);
      point += move * std::min(1.0, reach / std::max(move.norm(), std::numeric_limits<double>::min()));
    }
    return std::nullopt;
  }

  double border_distance(int face, const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    const auto edges = edges_of_face_.find(face);
    if (edges == edges_of_face_.end()) return least;
    for (int edge : edges->second)
      least = std::min(least, (boundary_.project_to_edge(edge, point).position - point).norm());
    return least;
  }

  /// True where two triangles of one face cut each other like faces that cross, not like two sides of a thin
  /// wall, and both run along the face.
  bool cuts_steeply(int t, int u) const {
    constexpr double kSteep = 0.5, kAligned = 0.9;
    if (normal(t).cross(normal(u)).norm() < kSteep) return false;
    const auto aligned = [&](int a) {
      return boundary_.project_to_face(samples_.triangle_face[a], centre(a)).normal.dot(normal(a)) > kAligned;
    };
    return aligned(t) && aligned(u);
  }

  [[noreturn]] void refuse(int face, int other, const Vec3& point) const {
    std::ostringstream text;
    text << "Face" << face;
    if (face == other)
      text << " crosses itself near " << Shown{point} << " mm; redraw it, or split it and keep one part";
    else
      text << " and Face" << other << " cross or touch each other near " << Shown{point}
           << " mm; move them apart, or unite the parts with Part -> Boolean";
    throw GeometryError(text.str());
  }

  [[noreturn]] void refuse_tangent(int face, int other, int edge) const {
    std::ostringstream text;
    text << "Face" << face << " and Face" << other << " touch each other along Edge" << edge
         << " like tangents, so that the wall or gap between them has no thickness there; move one of them";
    throw GeometryError(text.str());
  }

  const SampledBoundary& samples_;
  const BoundaryGeometry& boundary_;
  RunControl& control_;
  double diagonal_;
  std::vector<std::vector<int>> triangles_at_;  // each sample
  std::map<int, std::vector<int>> edges_of_face_;
  std::map<std::pair<int, int>, int> looks_;
};

}  // namespace

void require_no_crossing_faces(const SampledBoundary& samples, const BoundaryGeometry& boundary,
                               RunControl& control) {
  CrossingSearch(samples, boundary, control).run();
}

}  // namespace fgmesh
