// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/odt_smoothing.hpp"

#include "mesh/blocks.hpp"
#include "mesh/stretch.hpp"
#include "mesh/swap_pass.hpp"

namespace fgmesh {
namespace {

/// |T| times the circumcentre, relative to the first corner; finite even where T is flat.
Vec3 weighted_circumcentre(const Vec3& ab, const Vec3& ac, const Vec3& ad) {
  return (ab.squaredNorm() * ac.cross(ad) + ac.squaredNorm() * ad.cross(ab) +
          ad.squaredNorm() * ab.cross(ac)) /
         12.0;
}

Vec3 target_in_solid(const MeshState& state, int v, const std::vector<int>& star) {
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  const Vertex& own = state.vertices[v];
  const Stretch stretch{&own};
  for (int t : star) {
    const std::array<int, 4>& index = state.complex.tet(t).vertex;
    const int* others = kFaceVertices[state.complex.tet(t).index_of(v)];
    const Vertex &b = state.vertices[index[others[0]]], &c = state.vertices[index[others[1]]],
                 &d = state.vertices[index[others[2]]];
    const Vec3 ab = way_in_layers(own, b), ac = way_in_layers(own, c), ad = way_in_layers(own, d);
    const double size = 0.25 * (own.size + b.size + c.size + d.size);
    const double longer = Stretch{&own, &b, &c, &d}.factor();
    const double density = 1.0 / (size * size * size * longer * longer);
    weights += density * ab.cross(ac).dot(ad) / 6.0;
    sum += density * stretch.back(weighted_circumcentre(ab, ac, ad));
  }
  return weights > 0.0 ? Vec3(own.position + sum / weights) : own.position;
}

Vec3 target_on_face(const MeshState& state, int v, const std::vector<int>& star) {
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  const Vertex& moving = state.vertices[v];
  const Stretch stretch{&moving};
  for (int t : star) {
    const Tet& tet = state.complex.tet(t);
    const int own = tet.index_of(v);
    for (int i = 0; i < 4; ++i) {
      if (!tet.label[i] || i == own) continue;
      std::array<int, 2> other{};
      for (int j = 0, k = 0; j < 4; ++j)
        if (j != i && j != own) other[k++] = tet.vertex[j];
      const Vertex &b = state.vertices[other[0]], &c = state.vertices[other[1]];
      const Vec3 ab = way_in_layers(moving, b), ac = way_in_layers(moving, c), normal = ab.cross(ac);
      const double twice_area = normal.norm();
      if (!(twice_area > 0.0)) continue;
      const double size = (moving.size + b.size + c.size) / 3.0;
      const double weight = twice_area / (size * size);
      const Vec3 centre = (ab.squaredNorm() * ac.cross(normal) + ac.squaredNorm() * normal.cross(ab)) /
                          (2.0 * twice_area * twice_area);
      weights += weight;
      sum += weight * stretch.back(centre);
    }
  }
  return weights > 0.0 ? Vec3(moving.position + sum / weights) : moving.position;
}

Vec3 target_on_edge(const MeshState& state, int v, const std::vector<int>& star) {
  std::vector<int> neighbours;
  for (int t : star)
    for (int w : state.complex.tet(t).vertex)
      if (w != v && state.complex.crease(v, w) &&
          std::find(neighbours.begin(), neighbours.end(), w) == neighbours.end())
        neighbours.push_back(w);
  const Vec3& p = state.position(v);
  Vec3 sum = Vec3::Zero();
  double weights = 0.0;
  for (int w : neighbours) {
    const Vec3 way = state.position(w) - p;
    const Stretch stretch{&state.vertices[v], &state.vertices[w]};
    const double size = 0.5 * stretch.factor() * (state.vertices[v].size + state.vertices[w].size);
    const double weight = std::sqrt(stretch.squared_length(way)) / size;
    weights += weight;
    sum += 0.5 * weight * way;
  }
  return weights > 0.0 ? Vec3(p + sum / weights) : p;
}

/// The flattest tetrahedron of the star, with v imagined elsewhere.
double flatness(const MeshState& state, int v, const Vertex& moved, const std::vector<int>& star) {
  double worst = 1.0;
  for (int t : star) {
    const std::array<int, 4>& index = state.complex.tet(t).vertex;
    const auto at = [&](int i) -> const Vertex& { return index[i] == v ? moved : state.vertices[index[i]]; };
    worst = std::min(worst, StretchedTet(at(0), at(1), at(2), at(3)).flatness());
  }
  return worst;
}

}  // namespace

void update_sizes(MeshState& state, const SizingField& sizing) {
  for_ranges_at_once(state.vertices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vertex& vertex = state.vertices[v];
      vertex.size = sizing.at(steepest(vertex.own.gradient));
      for (const MaterialValue& other : vertex.others)
        vertex.size = std::min(vertex.size, sizing.at(steepest(other.gradient)));
    }
  });
  limit_growth(state, sizing.growth);
  update_stretches(state, sizing);
}

Vec3 odt_target(const MeshState& state, int v, const std::vector<int>& star) {
  switch (state.vertices[v].carrier.dimension) {
    case 0:
      return state.position(v);
    case 1:
      return target_on_edge(state, v, star);
    case 2:
      return target_on_face(state, v, star);
    default:
      return target_in_solid(state, v, star);
  }
}

void odt_sweep(MeshState& state, double damping, RunControl& control) {
  constexpr double kFlat = 2e-3;  // a regular tetrahedron has 0.048
  sweep_vertices(state, control, [&](int v, std::vector<int>& star) {
    const Vertex& vertex = state.vertices[v];
    if (vertex.frozen || vertex.is_fixed()) return;
    state.complex.star(v, star);
    const Vec3 way = damping * (odt_target(state, v, star) - vertex.position);
    const double least = std::min(kFlat, flatness(state, v, vertex, star));
    for (double part = 1.0; part > 0.2; part *= 0.5) {
      const std::optional<Vertex> moved = state.moved(vertex, vertex.position + part * way);
      if (!moved || !may_move(state, v, *moved, star)) continue;
      if (!(flatness(state, v, *moved, star) > std::max(1e-6, least))) continue;
      const double size = vertex.size;
      state.vertices[v] = *moved;
      state.vertices[v].size = size;
      break;
    }
  });
  swap_pass(state, OdtEnergy(state), control);
}

}  // namespace fgmesh
