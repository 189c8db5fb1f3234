// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/surface_mesh.hpp"

#include <algorithm>
#include <tuple>

namespace fgmesh {
namespace {

constexpr double kLargestChordError = 0.1;       // of the length of an edge
constexpr double kLargestHeightError = 0.25;     // of the height of a triangle over an edge
constexpr double kSlender = 0.05, kFlat = 1e-3;  // see SurfaceMesh::slenderness()

}  // namespace

SurfaceMesh::SurfaceMesh(const MeshState& state, const SampledBoundary& samples)
    : vertices(samples.points.size()), state_(state), at_(samples.points.size()) {
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    vertices[v].position = samples.points[v];
    vertices[v].carrier = {3, 0};
  }
  const auto carry = [&](int v, Carrier carrier) {
    if (vertices[v].carrier.dimension > carrier.dimension) vertices[v].carrier = carrier;
  };
  for (const SampledBoundary::Corner& corner : samples.corners) carry(corner.point, {0, corner.vertex});
  for (const SampledBoundary::Curve& curve : samples.curves) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      carry(curve.points[i], {1, curve.edge});
      if (i > 0) creases_[key(curve.points[i - 1], curve.points[i])] = curve.edge;
    }
  }
  for (std::size_t t = 0; t < samples.triangles.size(); ++t) {
    add({samples.triangles[t], samples.triangle_face[t], samples.triangle_solids[t]});
    for (int v : samples.triangles[t]) carry(v, {2, samples.triangle_face[t]});
  }
  for (Vertex& vertex : vertices) {
    if (vertex.carrier.dimension == 0)
      vertex.position = state.boundary().vertex_position(vertex.carrier.number);
    vertex = state.carried(vertex, vertex.position, false);
  }
}

int SurfaceMesh::add_vertex(const Vertex& vertex) {
  vertices.push_back(vertex);
  at_.emplace_back();
  return static_cast<int>(vertices.size()) - 1;
}

void SurfaceMesh::add(const SurfaceTriangle& triangle) {
  const int t = static_cast<int>(triangles.size());
  triangles.push_back(triangle);
  for (int v : triangle.vertex) at_[v].push_back(t);
}

void SurfaceMesh::remove(int t) {
  for (int v : triangles[t].vertex) {
    std::vector<int>& list = at_[v];
    list.erase(std::find(list.begin(), list.end(), t));
  }
  triangles[t].face = 0;
}

void SurfaceMesh::at_edge(int a, int b, std::vector<int>& found) const {
  found.clear();
  for (int t : at_[a])
    if (triangles[t].has(b)) found.push_back(t);
}

int SurfaceMesh::crease(int a, int b) const {
  const auto found = creases_.find(key(a, b));
  return found == creases_.end() ? 0 : found->second;
}

double SurfaceMesh::volume() const {
  double sum = 0.0;
  // About a point of the part: far from the origin, rounding would be larger than the volume.
  const Vec3 origin = vertices.empty() ? Vec3(Vec3::Zero()) : vertices.front().position;
  for (const SurfaceTriangle& triangle : triangles) {
    if (!triangle.alive()) continue;
    const Vec3 a = position(triangle.vertex[0]) - origin, b = position(triangle.vertex[1]) - origin,
               c = position(triangle.vertex[2]) - origin;
    const int sides = (triangle.solid[0] > 0) - (triangle.solid[1] > 0);  // 0: between two solids
    sum += sides * a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

int SurfaceMesh::split(int a, int b, const Vec3& target) {
  std::vector<int> around;
  at_edge(a, b, around);
  const int edge = crease(a, b);
  if (around.empty()) return -1;
  if (!edge) {
    // In a thin wedge two faces may have the edge in common: their middles are apart.
    const int face = triangles[around.front()].face;
    around.erase(
        std::remove_if(around.begin(), around.end(), [&](int t) { return triangles[t].face != face; }),
        around.end());
  }
  Vertex middle;
  middle.carrier = edge ? Carrier{1, edge} : Carrier{2, triangles[around.front()].face};
  middle.size = 0.5 * (vertices[a].size + vertices[b].size);
  middle = state_.carried(middle, target, false);
  constexpr double kFarthest = 0.4;  // of the edge's length
  const double length = (position(a) - position(b)).norm();
  if ((middle.position - target).norm() > kFarthest * length || is_at_border(middle, target)) return -1;
  // In a triangle that is flat at its apex the middle would lie upon the apex; needles can be split.
  if (!edge && std::any_of(around.begin(), around.end(), [&](int t) {
        return (position(triangles[t].apex(a, b)) - middle.position).norm() < kFlat * length;
      }))
    return -1;
  const int v = add_vertex(middle);
  for (int t : around) {
    SurfaceTriangle first = triangles[t], second = triangles[t];
    std::replace(first.vertex.begin(), first.vertex.end(), b, v);
    std::replace(second.vertex.begin(), second.vertex.end(), a, v);
    remove(t);
    add(first);
    add(second);
  }
  if (edge) {
    creases_.erase(key(a, b));
    creases_[key(a, v)] = creases_[key(v, b)] = edge;
  }
  return v;
}

void SurfaceMesh::meet(int t, int v) {
  const SurfaceTriangle whole = triangles[t];
  remove(t);
  for (int i = 0; i < 3; ++i) {
    SurfaceTriangle part = whole;
    part.vertex[i] = v;
    add(part);
  }
}

Vec3 SurfaceMesh::normal(const SurfaceTriangle& triangle) const {
  const std::array<int, 3>& v = triangle.vertex;
  return area_vector(position(v[0]), position(v[1]), position(v[2]));
}

double SurfaceMesh::slenderness(const std::array<int, 3>& v) const {
  const Vec3 &a = position(v[0]), &b = position(v[1]), &c = position(v[2]);
  const double longest = std::max({(a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm()});
  return area_vector(a, b, c).norm() / longest;
}

bool SurfaceMesh::faces_out(const std::array<int, 3>& v, int face, double slenderest) const {
  return slenderness(v) > slenderest &&
         faces_outward(state_, vertices[v[0]], vertices[v[1]], vertices[v[2]], face);
}

SurfaceMesh::Neighbours SurfaceMesh::neighbours(int v, int w) const {
  Neighbours found;
  std::vector<int> others;
  for (const auto& [vertex, list] : {std::pair(v, &found.own), std::pair(w, &others)}) {
    for (int t : at_[vertex])
      for (int p : triangles[t].vertex)
        if (p != v && p != w) list->push_back(p);
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  std::set_intersection(found.own.begin(), found.own.end(), others.begin(), others.end(),
                        std::back_inserter(found.both));
  // Who is a neighbour of both must be the apex of a triangle at the edge, or the surface would be pinched.
  std::vector<int> around;
  at_edge(v, w, around);
  found.closed = around.size() >= 2 && found.both.size() == around.size();
  return found;
}

void SurfaceMesh::replace(int v, int w) {
  for (int t : std::vector<int>(at_[v])) {
    SurfaceTriangle moved = triangles[t];
    remove(t);
    if (moved.has(w)) continue;
    std::replace(moved.vertex.begin(), moved.vertex.end(), v, w);
    add(moved);
  }
}

bool SurfaceMesh::merge(int v, int w) {
  const auto [own, both, closed] = neighbours(v, w);
  if (!closed) return false;
  // Two triangles on the same three vertices would be left.
  std::vector<int> around;
  for (int p : both) {
    at_edge(v, p, around);
    for (int t : around)
      for (int u : at_[w])
        if (!triangles[t].has(w) && triangles[u].has(p) && triangles[u].has(triangles[t].apex(v, p)))
          return false;
  }
  creases_.erase(key(v, w));
  for (int p : own) {
    const int edge = crease(v, p);
    if (!edge) continue;
    creases_.erase(key(v, p));
    if (!crease(w, p)) creases_[key(w, p)] = edge;
  }
  replace(v, w);
  return true;
}

bool SurfaceMesh::collapse(int v, int w, double chord, double longest) {
  const int dimension = vertices[v].carrier.dimension;
  const int edge = crease(v, w);
  if (dimension == 0 || (dimension == 1 && edge != vertices[v].carrier.number)) return false;
  const auto [own, both, closed] = neighbours(v, w);
  if (!closed) return false;
  // A crease of three edges is the least that bounds anything.
  int beyond = -1;
  if (dimension == 1) {
    for (int p : own)
      if (crease(v, p) == edge) beyond = p;
    if (beyond < 0 || std::binary_search(both.begin(), both.end(), beyond)) return false;
    if (crease_error(state_, vertices[beyond], vertices[w], edge) >
        std::min(chord, kLargestChordError * (position(beyond) - position(w)).norm()))
      return false;
  }
  for (int p : own)
    if (crease(v, p) && p != beyond) return false;

  for (int t : at_[v]) {
    if (triangles[t].has(w)) continue;
    std::array<int, 3> made = triangles[t].vertex;
    std::replace(made.begin(), made.end(), v, w);
    if (!faces_out(made, triangles[t].face, 0.02)) return false;
    const double twice_area = area_vector(position(made[0]), position(made[1]), position(made[2])).norm();
    for (int p : triangles[t].vertex) {
      const double length = (position(p) - position(w)).norm();
      if (p == v || length < 1e-3 * longest) continue;
      if (length > std::max(longest, 1.05 * (position(p) - position(v)).norm())) return false;
      // Across a narrow bent strip an edge would leave the strip.
      if (chord_error(state_, vertices[p], vertices[w], triangles[t].face) >
          std::min({chord, kLargestChordError * length, kLargestHeightError * twice_area / length}))
        return false;
    }
  }
  replace(v, w);
  creases_.erase(key(v, w));
  if (beyond >= 0) {
    creases_.erase(key(v, beyond));
    creases_[key(w, beyond)] = edge;
  }
  return true;
}

bool SurfaceMesh::unfold(int t) {
  struct Draw {
    int inward = 0;  ///< triangles at `from` that face inwards afterwards
    double length = 0.0;
    int from = -1, onto = -1;
  };
  Draw best;
  for (int v : triangles[t].vertex) {
    if (vertices[v].carrier.dimension != 2) continue;
    const auto inward = std::count_if(at_[v].begin(), at_[v].end(), [&](int u) { return !faces_out(u); });
    for (int w : neighbours(v, v).own) {
      if (!neighbours(v, w).closed) continue;
      Draw draw{0, (position(v) - position(w)).norm(), v, w};
      const auto is_best = [&] {
        return draw.inward < inward &&
               (best.from < 0 || std::tie(draw.inward, draw.length) < std::tie(best.inward, best.length));
      };
      bool flat = false;
      for (int u : at_[v]) {
        if (triangles[u].has(w)) continue;
        std::array<int, 3> made = triangles[u].vertex;
        std::replace(made.begin(), made.end(), v, w);
        flat = slenderness(made) < std::min(kFlat, slenderness(triangles[u].vertex));
        draw.inward += !flat && !faces_out(made, triangles[u].face, 0.0);
        // At a vertex of very many triangles most draws are out of the question after the first few.
        if (flat || !is_best()) break;
      }
      if (!flat && is_best()) best = draw;
    }
  }
  if (best.from < 0) return false;
  replace(best.from, best.onto);
  return true;
}

std::optional<SurfaceMesh::Quadrilateral> SurfaceMesh::quadrilateral(int a, int b) const {
  if (crease(a, b)) return std::nullopt;
  std::vector<int> around;
  at_edge(a, b, around);
  if (around.size() != 2 || triangles[around[0]].face != triangles[around[1]].face) return std::nullopt;
  const Quadrilateral quad{
      {around[0], around[1]}, triangles[around[0]].apex(a, b), triangles[around[1]].apex(a, b)};
  if (quad.c == quad.d) return std::nullopt;
  at_edge(quad.c, quad.d, around);
  return around.empty() ? std::optional(quad) : std::nullopt;
}

std::array<SurfaceTriangle, 2> SurfaceMesh::exchanged(int a, int b, const Quadrilateral& quad) const {
  std::array<SurfaceTriangle, 2> made = {triangles[quad.triangles[0]], triangles[quad.triangles[1]]};
  std::replace(made[0].vertex.begin(), made[0].vertex.end(), b, quad.d);  // (a, b, c) -> (a, d, c)
  std::replace(made[1].vertex.begin(), made[1].vertex.end(), a, quad.c);  // (b, a, d) -> (b, c, d)
  return made;
}

bool SurfaceMesh::exchange(int a, int b) {
  const std::optional<Quadrilateral> quad = quadrilateral(a, b);
  if (!quad) return false;
  replace(*quad, exchanged(a, b, *quad));
  return true;
}

void SurfaceMesh::replace(const Quadrilateral& quad, const std::array<SurfaceTriangle, 2>& made) {
  for (int t : quad.triangles) remove(t);
  for (const SurfaceTriangle& triangle : made) add(triangle);
}

bool SurfaceMesh::flip(int a, int b, double chord) {
  const std::optional<Quadrilateral> quad = quadrilateral(a, b);
  if (!quad) return false;
  const SurfaceTriangle &first = triangles[quad->triangles[0]], &second = triangles[quad->triangles[1]];
  const int c = quad->c, d = quad->d;
  const auto angle = [&](int apex) {
    const Vec3 p = position(a) - position(apex), q = position(b) - position(apex);
    return std::atan2(p.cross(q).norm(), p.dot(q));
  };
  // A triangle that the samples have turned over lies upon its neighbour; the other diagonal parts them.
  const bool folded = normal(first).dot(normal(second)) < 0.0 && !(faces_out(first.vertex, first.face, 0.0) &&
                                                                   faces_out(second.vertex, first.face, 0.0));
  if (!folded && angle(c) + angle(d) <= M_PI + 1e-6) return false;
  const auto error = [&](int p, int q) { return chord_error(state_, vertices[p], vertices[q], first.face); };
  double allowed =
      std::max(std::min(chord, kLargestChordError * (position(c) - position(d)).norm()), error(a, b));
  // Slivers must go even where the error rises; but unbounded, a chain of flips leads straight through a
  // bore.
  constexpr double kFartherThanOld = 1.25;
  if (folded || std::min(slenderness(first.vertex), slenderness(second.vertex)) <= kSlender)
    allowed =
        std::max(allowed, kFartherThanOld * std::max({error(a, c), error(c, b), error(b, d), error(d, a)}));
  if (error(c, d) > allowed) return false;
  const std::array<SurfaceTriangle, 2> made = exchanged(a, b, *quad);
  for (const SurfaceTriangle& triangle : made)
    if (!faces_out(triangle.vertex, first.face, 1e-4)) return false;
  replace(*quad, made);
  return true;
}

}  // namespace fgmesh
