// SPDX-License-Identifier: GPL-3.0-or-later
#include "quality/small_angles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "quality/tet_measures.hpp"

namespace fgmesh {
namespace {

/// Cosine between the normals of two sides of a wall at most: 30 degrees from parallel.
constexpr double kOpposite = -0.87;

/// Not for rounding alone, where a shape meets at just kAngleGoal.
bool is_small(double angle) {
  constexpr double kRounding = 1e-6;
  return angle < (1.0 - kRounding) * kAngleGoal;
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegrees;
}

Vec3 centre_of(const TetMesh& mesh, const std::array<std::int32_t, 4>& tet) {
  return (mesh.points[tet[0]] + mesh.points[tet[1]] + mesh.points[tet[2]] + mesh.points[tet[3]]) / 4.0;
}

/// The candidate that is nearest to the angle found in the mesh.
double nearest(double meshed, std::initializer_list<double> candidates) {
  return *std::min_element(candidates.begin(), candidates.end(),
                           [&](double a, double b) { return std::abs(a - meshed) < std::abs(b - meshed); });
}

using Triangle = std::array<std::int32_t, 3>;

Triangle sorted(Triangle corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// FaceN of each facet, by its sorted corners.
std::map<Triangle, int> facets_of(const TetMesh& mesh) {
  std::map<Triangle, int> facets;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    facets[sorted(mesh.triangles[i])] = mesh.triangle_faces[i];
  return facets;
}

/// Where the shape itself has angles below kAngleGoal.
class SharpFeatures {
 public:
  SharpFeatures(const TetMesh& mesh, const BoundaryGeometry& boundary, const PartName& name)
      : mesh_(mesh), boundary_(boundary), name_(name), sharp_(mesh.points.size(), 0) {
    for (std::size_t i = 0; i < mesh.edges.size(); ++i)
      creases_[between(mesh.edges[i][0], mesh.edges[i][1])] = mesh.edge_edges[i];
    find_wedges();
    find_corners();
  }

  bool touch(std::int32_t point) const { return sharp_[point]; }
  const std::string& sharpest() const { return sharpest_; }

 private:
  using Edge = std::array<std::int32_t, 2>;

  /// What a solid has between its two faces at a mesh edge.
  struct Wedge {
    double meshed = 0.0;  ///< sum of the angles of the tetrahedra
    std::vector<int> faces;
  };
  /// What a face has between its two edges at a vertex.
  struct Corner {
    double meshed = 0.0;
    std::vector<std::pair<int, std::int32_t>> edges;  ///< EdgeN, and the next point along it
  };

  static Edge between(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

  int crease(std::int32_t a, std::int32_t b) const {
    if (mesh_.carriers[a].dimension > 1 || mesh_.carriers[b].dimension > 1) return 0;
    const auto found = creases_.find(between(a, b));
    return found == creases_.end() ? 0 : found->second;
  }

  void find_wedges() {
    const std::map<Triangle, int> facets = facets_of(mesh_);
    std::map<std::pair<Edge, int>, Wedge> wedges;  // of mesh edge and SolidN
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const auto& v = mesh_.tets[t];
      for (int e = 0; e < 6; ++e) {
        const std::int32_t a = v[kEdgeVertices[e][0]], b = v[kEdgeVertices[e][1]];
        if (!crease(a, b)) continue;
        Wedge& wedge = wedges[{between(a, b), mesh_.tet_solids[t]}];
        const auto cosines =
            dihedral_cosines(mesh_.points[v[0]], mesh_.points[v[1]], mesh_.points[v[2]], mesh_.points[v[3]]);
        wedge.meshed += angle_of(cosines[e]);
        for (const int other : kEdgeVertices[5 - e]) {
          const auto facet = facets.find(sorted({a, b, v[other]}));
          if (facet != facets.end()) wedge.faces.push_back(facet->second);
        }
      }
    }
    for (const auto& [place, wedge] : wedges) {
      const auto& [a, b] = place.first;
      const int edge = crease(a, b);
      const Vec3 middle = 0.5 * (mesh_.points[a] + mesh_.points[b]);
      for (const Vec3& p :
           {mesh_.points[a], boundary_.project_to_edge(edge, middle).position, mesh_.points[b]})
        note(true_angle(wedge, p), "the faces at " + name_({1, edge}), p, {a, b});
    }
  }

  double true_angle(const Wedge& wedge, const Vec3& p) const {
    // Two sides of one face, or four faces, cannot be told apart by their normals.
    if (wedge.faces.size() != 2 || wedge.faces[0] == wedge.faces[1]) return wedge.meshed;
    const Vec3 a = boundary_.project_to_face(wedge.faces[0], p).normal;
    const Vec3 b = boundary_.project_to_face(wedge.faces[1], p).normal;
    if (a.isZero() || b.isZero()) return wedge.meshed;
    // Whichever way the normals point: of a narrow wedge and a narrow slit the mesh tells which it is.
    const double angle = angle_between(a, b);
    return nearest(wedge.meshed, {angle, 180.0 - angle, 180.0 + angle, 360.0 - angle});
  }

  void find_corners() {
    std::map<std::pair<std::int32_t, int>, Corner> corners;  // of point and FaceN
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const std::int32_t v = mesh_.triangles[t][i];
        if (mesh_.carriers[v].dimension != 0) continue;
        Corner& corner = corners[{v, mesh_.triangle_faces[t]}];
        const std::int32_t next = mesh_.triangles[t][(i + 1) % 3], last = mesh_.triangles[t][(i + 2) % 3];
        corner.meshed +=
            angle_between(mesh_.points[next] - mesh_.points[v], mesh_.points[last] - mesh_.points[v]);
        for (const std::int32_t end : {next, last})
          if (const int edge = crease(v, end)) corner.edges.push_back({edge, end});
      }
    }
    for (const auto& [place, corner] : corners) {
      const std::int32_t v = place.first;
      note(true_angle(corner, v),
           "two edges of " + name_({2, place.second}) + " at " + name_(mesh_.carriers[v]), mesh_.points[v],
           {v});
    }
  }

  double true_angle(const Corner& corner, std::int32_t v) const {
    // A closed edge has two tangents at its vertex, of which the projection finds one; a cone's tip has no
    // edge.
    if (corner.edges.size() != 2 || corner.edges[0].first == corner.edges[1].first)
      return corner.edges.empty() ? 360.0 : corner.meshed;
    std::array<Vec3, 2> away;
    for (int i = 0; i < 2; ++i) {
      const auto& [edge, end] = corner.edges[i];
      away[i] = boundary_.project_to_edge(edge, mesh_.points[v]).tangent;
      if (away[i].dot(mesh_.points[end] - mesh_.points[v]) < 0.0) away[i] = -away[i];
    }
    const double angle = angle_between(away[0], away[1]);
    return nearest(corner.meshed, {angle, 360.0 - angle});
  }

  void note(double angle, const std::string& who, const Vec3& place, std::initializer_list<std::int32_t> at) {
    if (!is_small(angle)) return;
    for (const std::int32_t point : at) sharp_[point] = 1;
    if (!(angle < least_)) return;
    least_ = angle;
    std::ostringstream text;
    text.precision(3);
    text << who << " meet at " << (angle < 1e-3 ? 0.0 : angle) << " degrees at ";
    text.precision(6);
    text << Shown{place} << " mm";
    sharpest_ = text.str();
  }

  const TetMesh& mesh_;
  const BoundaryGeometry& boundary_;
  const PartName& name_;
  std::map<Edge, int> creases_;  ///< EdgeN of each mesh edge along one
  std::vector<char> sharp_;      ///< of each point
  double least_ = kAngleGoal;
  std::string sharpest_;
};

/// Points on walls thinner than the smallest size.
class ThinWalls {
 public:
  ThinWalls(const TetMesh& mesh, const BoundaryGeometry& boundary, double min_size)
      : mesh_(mesh), boundary_(boundary), min_size_(min_size) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const std::int32_t v : mesh.triangles[t]) faces_[v].insert(mesh.triangle_faces[t]);
    find_solids();
  }

  /// Looks for walls that tetrahedron t spans.
  void look_at(std::size_t t) {
    for (const std::int32_t a : mesh_.tets[t])
      for (const std::int32_t b : mesh_.tets[t])
        if (is_across(a, b, mesh_.tet_solids[t])) found_.insert({a, b});
  }

  bool touch(std::int32_t point) const { return found_.count(point) > 0; }

  /// True for a point near both sides of a wall that was found; facets may leave it beside them.
  bool enclose(const Vec3& p) const {
    return std::any_of(sides_.begin(), sides_.end(), [&](const std::pair<int, int>& sides) {
      const Vec3 a = boundary_.project_to_face(sides.first, p).position - p;
      const Vec3 b = boundary_.project_to_face(sides.second, p).position - p;
      return a.norm() + b.norm() < min_size_;
    });
  }

 private:
  void find_solids() {
    const std::map<Triangle, int> facets = facets_of(mesh_);
    const auto is_inner = [&](std::int32_t v) { return mesh_.carriers[v].dimension == 3; };
    for (std::size_t t = 0; t < mesh_.tets.size(); ++t) {
      const auto& tet = mesh_.tets[t];
      if (std::count_if(tet.begin(), tet.end(), is_inner) > 1) continue;
      for (int i = 0; i < 4; ++i) {
        const auto facet = facets.find(sorted({tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]}));
        if (facet != facets.end()) solids_[facet->second].insert(mesh_.tet_solids[t]);
      }
    }
  }

  /// Out of this solid, at the point of the face nearest to p; zero where the face does not bound the solid.
  Vec3 outward(int face, int solid, const Vec3& p) const {
    const auto found = solids_.find(face);
    if (found == solids_.end() || !found->second.count(solid)) return Vec3::Zero();
    // Normals point out of the lower one of two solids.
    const double sign = *found->second.begin() == solid ? 1.0 : -1.0;
    return sign * boundary_.project_to_face(face, p).normal;
  }

  /// True where `a` is nearer than min_size to a face opposite that `b` lies on, on the other side of the
  /// solid.
  bool is_across(std::int32_t a, std::int32_t b, int solid) {
    const auto here = faces_.find(a), there = faces_.find(b);
    if (here == faces_.end() || there == faces_.end()) return false;
    const Vec3& p = mesh_.points[a];
    for (const int face : there->second) {
      if (here->second.count(face)) continue;
      if (!((boundary_.project_to_face(face, p).position - p).norm() < min_size_)) continue;
      const Vec3 opposite = outward(face, solid, p);
      for (const int own : here->second)
        if (outward(own, solid, p).dot(opposite) < kOpposite) {
          sides_.insert(std::minmax(own, face));
          return true;
        }
    }
    return false;
  }

  const TetMesh& mesh_;
  const BoundaryGeometry& boundary_;
  double min_size_;
  std::map<std::int32_t, std::set<int>> faces_;  ///< of each boundary point
  std::map<int, std::set<int>> solids_;          ///< SolidN on both sides of each face
  std::set<std::int32_t> found_;                 ///< points on thin walls
  std::set<std::pair<int, int>> sides_;          ///< FaceN of both sides
};

}  // namespace

SmallAngles find_small_angles(const TetMesh& mesh, const std::vector<double>& dihedral_min,
                              const BoundaryGeometry& boundary, double min_size, const PartName& name) {
  SmallAngles result;
  if (std::none_of(dihedral_min.begin(), dihedral_min.end(), is_small)) return result;
  const SharpFeatures sharp(mesh, boundary, name);
  ThinWalls walls(mesh, boundary, min_size);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (is_small(dihedral_min[t])) walls.look_at(t);
  const auto is_forced = [&](std::int32_t v) { return sharp.touch(v) || walls.touch(v); };
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (!is_small(dihedral_min[t])) continue;
    const auto& tet = mesh.tets[t];
    const bool forced = std::any_of(tet.begin(), tet.end(), is_forced) || walls.enclose(centre_of(mesh, tet));
    (forced ? result.forced : result.unforced).push_back(static_cast<std::int32_t>(t));
  }
  result.sharpest = sharp.sharpest();
  if (result.sharpest.empty() && !result.forced.empty()) {
    std::ostringstream text;
    text << "walls are thinner than MinSize, " << min_size << " mm";
    result.sharpest = text.str();
  }
  return result;
}

std::vector<std::string> describe(const SmallAngles& angles, const TetMesh& mesh,
                                  const std::vector<double>& dihedral_min) {
  std::vector<std::string> messages;
  const auto told = [&](const std::vector<std::int32_t>& tets) {
    std::ostringstream text;
    text << tets.size() << " of " << mesh.tets.size() << " tetrahedra have a dihedral angle below "
         << kAngleGoal << " degrees";
    return text;
  };
  if (!angles.forced.empty())
    messages.push_back(told(angles.forced).str() + ", which the shape forces: " + angles.sharpest);
  if (!angles.unforced.empty()) {
    const std::int32_t worst =
        *std::min_element(angles.unforced.begin(), angles.unforced.end(),
                          [&](std::int32_t a, std::int32_t b) { return dihedral_min[a] < dihedral_min[b]; });
    std::ostringstream text = told(angles.unforced);
    text << " that the shape does not force, the worst " << dihedral_min[worst] << " degrees at "
         << Shown{centre_of(mesh, mesh.tets[worst])} << " mm: lower MaxSize or SurfaceDeviation";
    messages.push_back(text.str());
  }
  return messages;
}

}  // namespace fgmesh
