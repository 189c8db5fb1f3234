// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_remeshing.hpp"

#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "domain/cgal_types.hpp"

namespace fgmesh {
namespace {

constexpr double kTooLong = 1.4, kTooShort = 0.7;  // of the size wanted
constexpr int kPoll = 1024;                        // elements between two looks at the control
constexpr double kFlatness = 0.15;                 // the middle of an edge may be so far off its face

double length(const SurfaceMesh& mesh, int a, int b) { return (mesh.position(a) - mesh.position(b)).norm(); }

double size_at(const SurfaceMesh& mesh, int a, int b) {
  return 0.5 * (mesh.vertices[a].size + mesh.vertices[b].size);
}

/// Calls visit(a, b, face) for the three edges of each triangle.
template <class Visit>
void for_each_side(const SurfaceMesh& mesh, const Visit& visit) {
  for (const SurfaceTriangle& triangle : mesh.triangles)
    for (int i = 0; i < 3 && triangle.alive(); ++i)
      visit(triangle.vertex[i], triangle.vertex[(i + 1) % 3], triangle.face);
}

void limit_growth(SurfaceMesh& mesh, double growth, RunControl& control) {
  for (bool changed = true; changed;) {
    control.check();
    changed = false;
    for_each_side(mesh, [&](int a, int b, int) {
      Vertex &small = mesh.vertices[mesh.vertices[a].size < mesh.vertices[b].size ? a : b],
             &large = mesh.vertices[mesh.vertices[a].size < mesh.vertices[b].size ? b : a];
      const double limit = small.size + growth * length(mesh, a, b);
      if (large.size > limit * (1.0 + 1e-3)) {
        large.size = limit;
        changed = true;
      }
    });
  }
}

/// The size that the curvature along an edge allows whose middle is `error` off: by the deviation, and by how
/// far normals turn.
double curvature_size(double length, double error, const SurfaceRemeshingOptions& options) {
  constexpr double kLargestTurn = 1.0;  // of the normal along an edge, radians
  if (!(error > 1e-9 * length)) return options.size;
  const double radius = length * length / (8.0 * error);
  return std::min({options.size, std::sqrt(8.0 * radius * options.deviation), kLargestTurn * radius});
}

double error_of(const SurfaceMesh& mesh, int a, int b, int face) {
  const int edge = mesh.crease(a, b);
  return edge ? crease_error(mesh.state(), mesh.vertices[a], mesh.vertices[b], edge)
              : chord_error(mesh.state(), mesh.vertices[a], mesh.vertices[b], face);
}

void set_sizes(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  for (Vertex& vertex : mesh.vertices) vertex.size = options.size;
  for_each_side(mesh, [&](int a, int b, int face) {
    const double size = length(mesh, a, b);
    const double wanted = std::max(size, curvature_size(size, error_of(mesh, a, b, face), options));
    for (int v : {a, b}) mesh.vertices[v].size = std::min(mesh.vertices[v].size, wanted);
  });
  limit_growth(mesh, options.growth, control);
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
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % kPoll == 0) control.check();
    if (!mesh.triangles[t].alive()) continue;
    const std::array<int, 3> v = mesh.triangles[t].vertex;
    const int face = mesh.triangles[t].face;
    int longest = 0;
    for (int i = 1; i < 3; ++i)
      if (length(mesh, v[i], v[(i + 1) % 3]) > length(mesh, v[longest], v[(longest + 1) % 3])) longest = i;
    const int a = v[longest], b = v[(longest + 1) % 3];
    if (!is_too_long(mesh, a, b, face, options)) continue;
    const int middle = mesh.split(a, b);
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
    if (v % kPoll == 0) control.check();
    if (mesh.at(v).empty() || mesh.vertices[v].carrier.dimension == 0) continue;
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
    if (normal.dot(before) < 0.0 || !faces_outward(at(0), at(1), at(2))) return -1.0;
    worst = std::min(worst, normal.norm() / longest);
  }
  return worst;
}

void smooth(SurfaceMesh& mesh, RunControl& control) {
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    if (v % kPoll == 0) control.check();
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
    moved.size = mesh.vertices[v].size;
    if (worst_shape(mesh, v, moved) > worst_shape(mesh, v, mesh.vertices[v])) mesh.vertices[v] = moved;
  }
}

/// Calls visit(t, u) for every two triangles without a common vertex that cut each other.
template <class Visit>
void for_each_crossing(const SurfaceMesh& mesh, const Visit& visit) {
  using Triangle = CgalKernel::Triangle_3;
  using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  std::vector<TriangleBox> boxes;
  const auto triangle = [&](int t) {
    const std::array<int, 3>& v = mesh.triangles[t].vertex;
    return Triangle(to_cgal(mesh.position(v[0])), to_cgal(mesh.position(v[1])), to_cgal(mesh.position(v[2])));
  };
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (mesh.triangles[t].alive()) boxes.emplace_back(triangle(t).bbox(), t);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const TriangleBox& a, const TriangleBox& b) {
    const int t = a.info(), u = b.info();
    for (int v : mesh.triangles[t].vertex)
      if (mesh.triangles[u].has(v)) return;
    const Triangle first = triangle(t), second = triangle(u);
    if (!first.is_degenerate() && !second.is_degenerate() && CGAL::do_intersect(first, second)) visit(t, u);
  });
}

/// Coarse triangles of two curved walls may cut each other: splits them, which brings both nearer to their
/// true faces, until none do.
void separate(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  constexpr int kMostRounds = 12;
  for (int round = 0; round < kMostRounds; ++round) {
    control.check();
    std::vector<std::array<int, 2>> edges;
    const auto add_worst_edge = [&](int t) {
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
      if (worst[0] >= 0) edges.push_back(worst);
    };
    for_each_crossing(mesh, [&](int t, int u) {
      add_worst_edge(t);
      add_worst_edge(u);
    });
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    if (edges.empty()) return;
    for (const auto& [a, b] : edges) mesh.split(a, b);
    make_surface_delaunay(mesh, control);
  }
}

}  // namespace

void make_surface_delaunay(SurfaceMesh& mesh, RunControl& control) {
  constexpr int kMostPasses = 8;
  int count = 1;
  for (int pass = 0; pass < kMostPasses && count > 0; ++pass) {
    count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (t % kPoll == 0) control.check();
      for (int i = 0; i < 3 && mesh.triangles[t].alive(); ++i) {
        const int a = mesh.triangles[t].vertex[i], b = mesh.triangles[t].vertex[(i + 1) % 3];
        count += mesh.flip(a, b, kFlatness * size_at(mesh, a, b));
      }
    }
  }
}

void remesh_surface(SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, RunControl& control) {
  set_sizes(mesh, options, control);
  constexpr int kMostRounds = 12;
  constexpr double kDone = 0.005;
  for (int round = 0; round < kMostRounds; ++round) {
    control.check();
    make_surface_delaunay(mesh, control);
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
  separate(mesh, options, control);
}

}  // namespace fgmesh
