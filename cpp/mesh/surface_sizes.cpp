// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_sizes.hpp"

#include <algorithm>

namespace fgmesh {
namespace {

constexpr int kPoll = 1024;  // elements between two looks at the control

double length(const SurfaceMesh& mesh, int a, int b) { return (mesh.position(a) - mesh.position(b)).norm(); }

/// Calls visit(a, b, face) for the three edges of each triangle.
template <class Visit>
void for_each_side(const SurfaceMesh& mesh, const Visit& visit) {
  for (const SurfaceTriangle& triangle : mesh.triangles)
    for (int i = 0; i < 3 && triangle.alive(); ++i)
      visit(triangle.vertex[i], triangle.vertex[(i + 1) % 3], triangle.face);
}

/// How thick the solids behind and before a triangle are at a point of its face, the thinner one.
double thickness_at(const SurfaceTriangle& triangle, const Vec3& start, const Vec3& outward,
                    const WallThickness& walls) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 2; ++side)
    if (triangle.solid[side])
      thinnest = std::min(
          thinnest, walls.at(start, side ? outward : Vec3(-outward), triangle.solid[side], triangle.face));
  return thinnest > 0.0 ? thinnest : std::numeric_limits<double>::infinity();
}

/// The same at the middle of a triangle; infinite where that is beside the face, as in a coarse triangle.
double thickness_at_middle(const SurfaceMesh& mesh, const SurfaceTriangle& triangle, const Vec3& outward,
                           const WallThickness& walls) {
  const Vec3 &a = mesh.position(triangle.vertex[0]), &b = mesh.position(triangle.vertex[1]),
             &c = mesh.position(triangle.vertex[2]);
  const Vec3 middle = (a + b + c) / 3.0;
  const Vec3 start = mesh.state().boundary().project_to_face(triangle.face, middle).position;
  if ((start - middle).cross(outward).norm() > 0.5 * (start - middle).norm())
    return std::numeric_limits<double>::infinity();
  return thickness_at(triangle, start, outward, walls);
}

/// How far the middle of the edge (a, b) of a triangle will move across the triangle when it is brought onto
/// its face or crease.
double error_across(const SurfaceMesh& mesh, int a, int b, int face, const Vec3& outward) {
  const int edge = mesh.crease(a, b);
  if (!edge) return chord_error(mesh.state(), mesh.vertices[a], mesh.vertices[b], face);
  const Vec3 middle = 0.5 * (mesh.position(a) + mesh.position(b));
  return std::abs(outward.dot(mesh.state().boundary().project_to_edge(edge, middle).position - middle));
}

/// How wide a narrow face, or a corner of one, is at a triangle between its edges; infinite elsewhere.
double strip_width(const SurfaceMesh& mesh, const SurfaceTriangle& triangle, double twice_area) {
  double longest = 0.0;
  int on_edges = 0;
  for (int i = 0; i < 3; ++i) {
    longest = std::max(longest, length(mesh, triangle.vertex[i], triangle.vertex[(i + 1) % 3]));
    on_edges += mesh.vertices[triangle.vertex[i]].carrier.dimension < 2;
  }
  return on_edges < 2 ? std::numeric_limits<double>::infinity() : twice_area / longest;
}

/// Lowers sizes where walls are thin and faces are narrow.
class WallRefinement {
 public:
  WallRefinement(SurfaceMesh& mesh, const WallThickness& walls, const SurfaceRemeshingOptions& options)
      : mesh_(mesh), walls_(walls), options_(options) {}

  void look_at_triangle(const SurfaceTriangle& triangle) {
    constexpr double kLargestError = 0.25, kAim = 0.15;  // of the thickness
    const std::array<int, 3>& v = triangle.vertex;
    const Vec3 area = area_vector(mesh_.position(v[0]), mesh_.position(v[1]), mesh_.position(v[2]));
    const double twice_area = area.norm();
    if (!(twice_area > 0.0)) return;
    const Vec3 outward = area / twice_area;
    const double thickness = thickness_at_middle(mesh_, triangle, outward, walls_);
    const double longest =
        std::min(longest_on_wall(thickness), kLongestInStrip * strip_width(mesh_, triangle, twice_area));
    for (int i = 0; i < 3; ++i) {
      const int a = v[i], b = v[(i + 1) % 3];
      double wanted = longest;
      const auto allow = [&](double error, double room) {
        if (error > kLargestError * room)
          wanted = std::min(wanted, length(mesh_, a, b) * std::sqrt(kAim * room / error));
      };
      allow(error_across(mesh_, a, b, triangle.face, outward), thickness);
      if (mesh_.crease(a, b)) allow(error_of(mesh_, a, b, triangle.face), twice_area / length(mesh_, a, b));
      lower(a, wanted);
      lower(b, wanted);
    }
  }

  /// Where a wall is thinnest at one place, the middles of triangles may all be away from it.
  void look_at_vertex(int v) {
    const Vertex& vertex = mesh_.vertices[v];
    if (mesh_.at(v).empty() || vertex.carrier.dimension != 2 || vertex.direction.isZero()) return;
    lower(v, longest_on_wall(thickness_at(mesh_.triangles[mesh_.at(v).front()], vertex.position,
                                          vertex.direction, walls_)));
  }

  bool lowered() const { return lowered_; }

 private:
  static constexpr double kLongest = 4.5;          // of the thickness of a wall
  static constexpr double kLongestInStrip = 30.0;  // of its width

  double longest_on_wall(double thickness) const {
    return thickness >= options_.min_size ? kLongest * thickness : std::numeric_limits<double>::infinity();
  }

  void lower(int v, double size) {
    constexpr double kLargestStep = 0.4;  // of sizes, so that a wrong thickness does no great harm
    double& own = mesh_.vertices[v].size;
    if (own <= std::max(size, options_.min_size)) return;
    lowered_ = true;
    own = std::max({size, kLargestStep * own, options_.min_size});
  }

  SurfaceMesh& mesh_;
  const WallThickness& walls_;
  const SurfaceRemeshingOptions& options_;
  bool lowered_ = false;
};

}  // namespace

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

double curvature_size(double length, double error, const SurfaceRemeshingOptions& options) {
  constexpr double kLargestTurn = 1.0;  // of the normal along an edge, radians
  if (!(error > 1e-9 * length)) return options.size;
  const double radius = length * length / (8.0 * error);
  return std::clamp(std::min(std::sqrt(8.0 * radius * options.deviation), kLargestTurn * radius),
                    options.min_size, options.size);
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

bool refine_walls(SurfaceMesh& mesh, const WallThickness& walls, const SurfaceRemeshingOptions& options,
                  RunControl& control) {
  WallRefinement refinement(mesh, walls, options);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (t % kPoll == 0) control.check();
    if (mesh.triangles[t].alive()) refinement.look_at_triangle(mesh.triangles[t]);
  }
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    if (v % kPoll == 0) control.check();
    refinement.look_at_vertex(v);
  }
  limit_growth(mesh, options.growth, control);
  return refinement.lowered();
}

}  // namespace fgmesh
