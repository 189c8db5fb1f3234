// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/stretch.hpp"

#include "core/parallel.hpp"

namespace fgmesh {
namespace {

/// Zero where the gradient vanishes or is none.
Vec3 unit(const Vec3& gradient) {
  const double slope = gradient.norm();
  return slope > 0.0 && std::isfinite(slope) ? Vec3(gradient / slope) : Vec3(Vec3::Zero());
}

/// How much the level set of f through a place is bent, 1/mm: by how the gradient turns within `step` along
/// it. The mesh itself may be too coarse to tell.
double curvature(const CompositionField& field, const Vec3& place, const Vec3& normal, double step) {
  const Vec3 first = normal.unitOrthogonal(), second = normal.cross(first);
  const std::array<Vec3, 2> places = {place + step * first, place + step * second};
  const std::size_t formulas = field.constituents() - 1;
  std::vector<double> fractions(2 * formulas);
  std::vector<Vec3> gradients(2 * formulas);
  field.evaluate(places.data(), 2, fractions.data(), gradients.data());
  double turn = 0.0;
  for (int i = 0; i < 2; ++i) {
    CompositionGradient gradient;
    for (std::size_t k = 0; k < formulas; ++k) gradient.push_back(gradients[2 * k + i]);
    const Vec3 there = unit(steepest(gradient));
    // Of several constituents the sign of the steepest way is arbitrary.
    turn = std::max(turn, std::min((there - normal).norm(), formulas > 1 ? (there + normal).norm() : 2.0));
  }
  return turn / step;
}

}  // namespace

Vec3 way_in_layers(const Vertex& from, const Vertex& to) {
  const Vec3 way = to.position - from.position;
  const Stretch own{&from};
  if (own.factor() == 1.0) return way;
  // The middle normal of two points on a sphere is square to the way between them.
  const double along = own.axis().dot(way), between = Stretch{&from, &to}.axis().dot(way);
  return way + (own.factor() * between + (along - between) / own.factor() - along) * own.axis();
}

StretchedTet::StretchedTet(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
    : volume(orientation(a.position, b.position, c.position, d.position)),
      squared_edges(fgmesh::squared_edges(a.position, b.position, c.position, d.position)) {
  const Stretch stretch{&a, &b, &c, &d};
  if (stretch.factor() == 1.0) return;
  factor = stretch.factor();
  squared_edges = 0.0;
  for (const auto& [p, q] : {std::pair(&a, &b), {&a, &c}, {&a, &d}, {&b, &c}, {&b, &d}, {&c, &d}})
    squared_edges += Stretch{p, q}.squared_length(q->position - p->position);
}

Vec3 stretch_at(const CompositionField& field, const Vec3& place, const Vec3& gradient, double size,
                const SizingField& sizing) {
  // An element may bulge over its level set by this part of its size along the gradient.
  constexpr double kBulge = 0.1;
  const Vec3 normal = unit(gradient);
  if (sizing.anisotropy == 1.0 || normal.isZero()) return Vec3::Zero();
  const double bent = curvature(field, place, normal, size);
  const double flat = std::sqrt(8.0 * kBulge / std::max(bent * size, 1e-12));
  const double factor = std::min({sizing.anisotropy, flat, sizing.max_size / size});
  return std::max(0.0, factor - 1.0) * normal;
}

void update_stretches(MeshState& state, const SizingField& sizing) {
  if (sizing.anisotropy == 1.0) return;
  for_ranges_at_once(state.vertices.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Vertex& vertex = state.vertices[v];
      vertex.stretch = stretch_at(state.materials().field(vertex.own.material), vertex.position,
                                  steepest(vertex.own.gradient), vertex.size, sizing);
    }
  });
}

}  // namespace fgmesh
