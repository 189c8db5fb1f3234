// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_remeshing.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "core/error.hpp"
#include "mesh/surface_sizes.hpp"
#include "mesh/triangle_crossings.hpp"

namespace fgmesh {
namespace {

constexpr double kTooLong = 1.4, kTooShort = 0.7;  // of the size wanted
constexpr int kPoll = 1024;                        // elements between two looks at the control
constexpr double kFlatness = 0.15;                 // the middle of an edge may be so far off its face

double length(const SurfaceMesh& mesh, int a, int b) { return (mesh.position(a) - mesh.position(b)).norm(); }

double size_at(const SurfaceMesh& mesh, int a, int b) {
  return 0.5 * (mesh.vertices[a].size + mesh.vertices[b].size);
}

/// Between two small features the size grows and falls again: an edge may be longer than its ends alone want,
/// but for the curvature.
bool is_too_long(const SurfaceMesh& mesh, int a, int b, int face, const SurfaceRemeshingOptions& options) {
  const double own = length(mesh, a, b), ends = size_at(mesh, a, b);
  if (own <= kTooLong * ends) return false;
  return own > kTooLong * std::min(options.size, ends + 0.25 * options.growth * own) ||
         own > kTooLong * curvature_size(own, error_of(mesh, a, b, face), options);
}

int split_long_edges(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  int count = 0;
  const std::size_t old_triangles = mesh.triangles.size();  // new ones wait, so that this ends on any face
  for (std::size_t t = 0; t < old_triangles; ++t) {
    if (t % kPoll == 0) control.check_at(mesh.position(mesh.triangles[t].vertex[0]));
    if (!mesh.triangles[t].alive()) continue;
    const std::array<int, 3> v = mesh.triangles[t].vertex;
    const int face = mesh.triangles[t].face;
    int longest = 0;
    for (int i = 1; i < 3; ++i)
      if (length(mesh, v[i], v[(i + 1) % 3]) > length(mesh, v[longest], v[(longest + 1) % 3])) longest = i;
    const int a = v[longest], b = v[(longest + 1) % 3];
    if (!is_too_long(mesh, a, b, face, options)) continue;
    const int middle = mesh.split(a, b);
    if (middle < 0) continue;
    double& size = mesh.vertices[middle].size;
    size = options.size;
    for (int end : {a, b}) {
      const double half = length(mesh, end, middle);
      size = std::min({size, mesh.vertices[end].size + options.growth * half,
                       std::max(half, curvature_size(half, error_of(mesh, end, middle, face), options))});
    }
    ++count;
  }
  return count;
}

int collapse_short_edges(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  int count = 0;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    if (v % kPoll == 0) control.check_at(mesh.position(v));
    if (mesh.at(v).empty() || mesh.vertices[v].is_fixed()) continue;
    std::vector<std::pair<double, int>> near;
    for (int t : mesh.at(v))
      for (int w : mesh.triangles[t].vertex) {
        if (w == v) continue;
        const double part = length(mesh, v, w) / size_at(mesh, v, w);
        if (part < kTooShort) near.emplace_back(part, w);
      }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const auto& [part, w] : near) {
      const double size = size_at(mesh, v, w);
      if (!mesh.collapse(v, w, std::min(options.deviation, kFlatness * size), kTooLong * size)) continue;
      ++count;
      break;
    }
  }
  return count;
}

/// The least altitude of the triangles at v over their longest edge, v imagined at `moved`; negative where
/// one folds over.
double worst_shape(const SurfaceMesh& mesh, int v, const Vertex& moved) {
  double worst = 1.0;
  for (int t : mesh.at(v)) {
    const std::array<int, 3>& index = mesh.triangles[t].vertex;
    const auto at = [&](int i) -> const Vertex& { return index[i] == v ? moved : mesh.vertices[index[i]]; };
    const Vec3 normal = area_vector(at(0).position, at(1).position, at(2).position);
    const Vec3 before =
        area_vector(mesh.position(index[0]), mesh.position(index[1]), mesh.position(index[2]));
    double longest = 0.0;
    for (int i = 0; i < 3; ++i)
      longest = std::max(longest, (at(i).position - at((i + 1) % 3).position).squaredNorm());
    if (normal.dot(before) < 0.0 || !faces_outward(mesh.state(), at(0), at(1), at(2), mesh.triangles[t].face))
      return -1.0;
    worst = std::min(worst, normal.norm() / longest);
  }
  return worst;
}

void smooth(SurfaceMesh& mesh, RunControl& control) {
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    if (v % kPoll == 0) control.check_at(mesh.position(v));
    if (mesh.at(v).empty() || mesh.vertices[v].carrier.dimension != 2) continue;
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;
    for (int t : mesh.at(v)) {
      const std::array<int, 3>& index = mesh.triangles[t].vertex;
      const Vec3 &a = mesh.position(index[0]), &b = mesh.position(index[1]), &c = mesh.position(index[2]);
      const double weight = area_vector(a, b, c).norm();
      sum += weight / 3.0 * (a + b + c);
      weights += weight;
    }
    if (!(weights > 0.0)) continue;
    Vertex moved = mesh.state().carried(mesh.vertices[v], sum / weights);
    if (is_at_border(moved, sum / weights)) continue;
    moved.size = mesh.vertices[v].size;
    if (worst_shape(mesh, v, moved) > worst_shape(mesh, v, mesh.vertices[v])) mesh.vertices[v] = moved;
  }
}

/// Splits the edges that two faces have in common inside both, as samples of a thin wedge do: there would be
/// nothing between the two.
void part_faces(SurfaceMesh& mesh, RunControl& control) {
  std::vector<int> around;
  const std::size_t old_triangles = mesh.triangles.size();
  for (std::size_t t = 0; t < old_triangles; ++t) {
    if (t % kPoll == 0) control.check_at(mesh.position(mesh.triangles[t].vertex[0]));
    for (int i = 0; i < 3 && mesh.triangles[t].alive(); ++i) {
      const int a = mesh.triangles[t].vertex[i], b = mesh.triangles[t].vertex[(i + 1) % 3];
      if (mesh.crease(a, b)) continue;
      mesh.at_edge(a, b, around);
      if (around.size() > 2) mesh.split(a, b);
    }
  }
}

/// Takes away vertices inside faces whose triangles face inwards. Each lowers the number of such triangles.
void unfold(SurfaceMesh& mesh, RunControl& control) {
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    if (t % kPoll == 0) control.check_at(mesh.position(mesh.triangles[t].vertex[0]));
    if (mesh.triangles[t].alive() && !mesh.faces_out(t)) mesh.unfold(t);
  }
}

/// Splits, collapses and flips edges and moves vertices until edges have the size wanted at their ends.
void remesh(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  constexpr int kMostRounds = 12;
  constexpr double kDone = 0.005;
  for (int round = 0; round < kMostRounds; ++round) {
    control.check();
    make_surface_delaunay(mesh, control);
    unfold(mesh, control);
    const int collapsed = collapse_short_edges(mesh, options, control);
    const int split = split_long_edges(mesh, options, control);
    limit_growth(mesh, options.growth, control);
    make_surface_delaunay(mesh, control);
    smooth(mesh, control);
    int alive = 0;
    for (const SurfaceTriangle& triangle : mesh.triangles) alive += triangle.alive();
    if (collapsed + split <= kDone * alive) break;
  }
  make_surface_delaunay(mesh, control);
  unfold(mesh, control);
}

/// The edge of a triangle that strays most from its face or crease; {-1, -1} where none does.
std::array<int, 2> worst_edge(const SurfaceMesh& mesh, int t, const SurfaceRemeshingOptions& options) {
  const SurfaceTriangle& triangle = mesh.triangles[t];
  double largest = 1e-9 * options.size;
  std::array<int, 2> worst = {-1, -1};
  for (int i = 0; i < 3; ++i) {
    const int a = triangle.vertex[i], b = triangle.vertex[(i + 1) % 3];
    const double error = error_of(mesh, a, b, triangle.face);
    if (error <= largest) continue;
    largest = error;
    worst = {std::min(a, b), std::max(a, b)};
  }
  return worst;
}

/// Where vertices of triangle t lie upon triangle u, as where a ball stands on a plane: a vertex of the shape
/// becomes one of both surfaces, one of a face moves along it.
void resolve_touch(SurfaceMesh& mesh, int t, int u) {
  constexpr double kUpon = 1e-6, kStep = 0.3;  // of an edge's length
  for (int i = 0; i < 3; ++i) {
    if (!mesh.triangles[t].alive() || !mesh.triangles[u].alive()) return;
    const int v = mesh.triangles[t].vertex[i], next = mesh.triangles[t].vertex[(i + 1) % 3];
    const std::array<int, 3> w = mesh.triangles[u].vertex;
    const Vec3 normal =
        area_vector(mesh.position(w[0]), mesh.position(w[1]), mesh.position(w[2])).normalized();
    const Vec3 way = mesh.position(next) - mesh.position(v);
    if (std::abs(normal.dot(mesh.position(v) - mesh.position(w[0]))) > kUpon * way.norm()) continue;
    if (mesh.vertices[v].carrier.dimension == 2) {
      const Vertex moved = mesh.state().carried(mesh.vertices[v], mesh.position(v) + kStep * way);
      if (worst_shape(mesh, v, moved) > 0.0) mesh.vertices[v] = moved;
    } else if (mesh.vertices[v].carrier.dimension == 0) {
      bool inside = true;
      for (int k = 0; k < 3; ++k)
        inside =
            inside &&
            area_vector(mesh.position(w[k]), mesh.position(w[(k + 1) % 3]), mesh.position(v)).dot(normal) >
                0.0;
      if (inside) mesh.meet(u, v);
    }
  }
}

[[noreturn]] void refuse_crossing(const SurfaceMesh& mesh, const std::array<int, 2>& pair) {
  const SurfaceTriangle &first = mesh.triangles[pair[0]], &second = mesh.triangles[pair[1]];
  std::ostringstream text;
  text << "Face" << std::min(first.face, second.face);
  if (first.face == second.face)
    text << " folds over itself";
  else
    text << " and Face" << std::max(first.face, second.face) << " cut each other";
  text << " near " << Shown{mesh.position(first.vertex[0])}
       << " mm, however fine the mesh is there; lower MaxSize and MinSize, or redraw the face";
  throw GeometryError(text.str());
}

/// Coarse triangles of two curved walls may cut each other: splits them, which brings both nearer to their
/// true faces, until none do. Where that makes more and more crossings the faces themselves are at fault.
void separate(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  constexpr int kMostRounds = 12;
  constexpr std::size_t kMany = 40, kDiverging = 3;  // crossings; times the fewest so far
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (int round = 0; round < kMostRounds; ++round) {
    control.check();
    std::vector<int> alive;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
      if (mesh.triangles[t].alive()) alive.push_back(t);
    std::vector<std::array<int, 2>> crossings, edges;
    for_each_crossing(
        alive, [&](int t) -> const std::array<int, 3>& { return mesh.triangles[t].vertex; },
        [&](int v) -> const Vec3& { return mesh.position(v); },
        [&](int t, int u) {
          crossings.push_back({t, u});
          crossings.push_back({u, t});
        });
    if (crossings.empty()) return;
    fewest = std::min(fewest, crossings.size());
    if (crossings.size() > std::max(kMany, kDiverging * fewest)) refuse_crossing(mesh, crossings.front());
    for (const auto& [t, u] : crossings) {
      if (!mesh.triangles[t].alive()) continue;  // an earlier touch has divided it
      edges.push_back(worst_edge(mesh, t, options));
      resolve_touch(mesh, t, u);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges)
      if (a >= 0) mesh.split(a, b);
    make_surface_delaunay(mesh, control);
  }
}

}  // namespace

void make_surface_delaunay(SurfaceMesh& mesh, RunControl& control) {
  constexpr int kMostPasses = 8;
  // Of new triangles by the number of old ones. In a plane flips come to an end; on a coarse bent surface a
  // ring of them may not. What they leave is less than Delaunay, but no worse than before.
  constexpr std::size_t kMostNew = 30;
  const std::size_t most = (kMostNew + 1) * mesh.triangles.size();
  int count = 1;
  for (int pass = 0; pass < kMostPasses && count > 0; ++pass) {
    count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size() && mesh.triangles.size() < most; ++t) {
      if (t % kPoll == 0) control.check_at(mesh.position(mesh.triangles[t].vertex[0]));
      for (int i = 0; i < 3 && mesh.triangles[t].alive(); ++i) {
        const int a = mesh.triangles[t].vertex[i], b = mesh.triangles[t].vertex[(i + 1) % 3];
        count += mesh.flip(a, b, kFlatness * size_at(mesh, a, b));
      }
    }
  }
}

void remesh_surface(SurfaceMesh& mesh, const WallThickness& walls, const SurfaceRemeshingOptions& options,
                    RunControl& control) {
  part_faces(mesh, control);
  set_sizes(mesh, options, control);
  constexpr int kMostRounds = 6;
  for (int round = 0; round < kMostRounds; ++round) {
    remesh(mesh, options, control);
    if (!refine_walls(mesh, walls, options, control)) break;
  }
  separate(mesh, options, control);
}

}  // namespace fgmesh
