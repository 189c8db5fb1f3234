// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_state.hpp"

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <string>

#include "core/error.hpp"

namespace fgmesh {
namespace {

/// Positions are exact to about this, mm (FreeCAD finds the nodes of a face within it).
constexpr double kPositionTolerance = 1e-7;

/// `is_fraction` tells which numbers a volume fraction may be.
template <class IsFraction>
[[noreturn]] void refuse(const Composition& fractions, const IsFraction& is_fraction, const Vec3& place) {
  std::ostringstream text;
  text.precision(10);
  const auto wrong = std::find_if_not(fractions.begin(), fractions.end(), is_fraction);
  const std::string which =
      fractions.size() == 1 ? "" : " of constituent " + std::to_string(wrong - fractions.begin() + 1);
  if (wrong == fractions.end()) {
    text << "the volume fractions sum up to " << std::accumulate(fractions.begin(), fractions.end(), 0.0)
         << ", more than 1,";
  } else if (std::isfinite(*wrong)) {
    text << "the volume fraction" << which << " is " << *wrong << ", outside [0, 1],";
  } else {
    text << "the volume fraction" << which << " is not a finite number";
  }
  text << " at the point " << Shown{place} << " of the solid; correct the formula, or bound it with "
       << (wrong == fractions.end() ? "min(..., 1 - ...)" : "clamp(..., 0, 1)");
  throw InvalidInput(text.str());
}

/// What CGAL::hilbert_sort() asks of places.
struct PlaceTraits {
  using Point_3 = Vec3;
  template <int axis>
  struct Less {
    bool operator()(const Vec3& a, const Vec3& b) const { return a[axis] < b[axis]; }
  };
  using Less_x_3 = Less<0>;
  using Less_y_3 = Less<1>;
  using Less_z_3 = Less<2>;
  Less_x_3 less_x_3_object() const { return {}; }
  Less_y_3 less_y_3_object() const { return {}; }
  Less_z_3 less_z_3_object() const { return {}; }
};
struct PlaceOf {
  using key_type = int;
  using value_type = Vec3;
  using reference = const Vec3&;
  using category = boost::readable_property_map_tag;
  friend reference get(const PlaceOf& map, int v) { return (*map.vertices)[v].position; }
  const std::vector<Vertex>* vertices;
};

/// No edge at the vertex becomes shorter than min_size and than those there are.
bool keeps_min_size(const MeshState& state, int v, const Vec3& place, const std::vector<int>& star) {
  double before = std::numeric_limits<double>::infinity(), after = before;
  for (int t : star) {
    for (int w : state.complex.tet(t).vertex) {
      if (w == v) continue;
      before = std::min(before, (state.position(w) - state.position(v)).squaredNorm());
      after = std::min(after, (state.position(w) - place).squaredNorm());
    }
  }
  return after >= std::min(before, state.min_size * state.min_size);
}

}  // namespace

const MaterialValue& Vertex::in(int material) const {
  for (const MaterialValue& other : others)
    if (other.material == material) return other;
  return own;
}

bool Vertex::has(int material) const {
  return own.material == material ||
         std::any_of(others.begin(), others.end(),
                     [&](const MaterialValue& other) { return other.material == material; });
}

double variation_at_interface(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  double largest = 0.0;
  const auto look = [&](int material) {
    if (!b.has(material) || !c.has(material) || !d.has(material)) return;
    largest =
        std::max(largest, composition_variation(a.in(material).composition, b.in(material).composition,
                                                c.in(material).composition, d.in(material).composition));
  };
  look(a.own.material);
  for (const MaterialValue& other : a.others) look(other.material);
  return largest;
}

bool MeshState::evaluate(const Vec3& place, const Carrier& carrier, MaterialValue& result) const {
  const CompositionField& field = materials_.field(result.material);
  const std::size_t formulas = field.constituents() - 1;
  result.composition.resize(formulas);
  result.gradient.resize(formulas);
  field.evaluate(&place, 1, result.composition.data(), result.gradient.data());
  double sum = 0.0, slope = 0.0;
  for (std::size_t i = 0; i < formulas; ++i) {
    Vec3& gradient = result.gradient[i];
    for (int k = 0; k < 3; ++k)
      if (!std::isfinite(gradient[k])) gradient[k] = std::copysign(1e3 / kPositionTolerance, gradient[k]);
    slope += gradient.norm();
    sum += result.composition[i];
  }
  const double tolerance = 1e-9 + kPositionTolerance * std::min(slope, 1e-3 / kPositionTolerance);
  const auto is_fraction = [&](double value) { return value >= -tolerance && value <= 1.0 + tolerance; };
  if (!std::all_of(result.composition.begin(), result.composition.end(), is_fraction) || !is_fraction(sum)) {
    // A place that is tried for an inner vertex may be beyond the boundary by less than its tolerance.
    const bool inner = carrier.dimension == 3;
    const int solid = inner && materials_.count() > 1 ? carrier.number : 0;
    if (boundary_.contains(place, solid, !inner)) refuse(result.composition, is_fraction, place);
    if (!std::isfinite(sum)) return false;
  }
  for (double& value : result.composition) value = std::clamp(value, 0.0, 1.0);
  return true;
}

bool MeshState::evaluate(Vertex& vertex) const {
  vertex.others.clear();
  if (materials_.count() == 1) {
    vertex.own.material = 0;
    return evaluate(vertex.position, vertex.carrier, vertex.own);
  }
  bool first = true;
  for (int material : materials_.at(vertex.carrier)) {
    MaterialValue& made = first ? vertex.own : vertex.others.emplace_back();
    made.material = material;
    if (!evaluate(vertex.position, vertex.carrier, made)) return false;
    first = false;
  }
  return true;
}

Vertex MeshState::carried(const Vertex& vertex, const Vec3& target, bool near) const {
  Vertex result = vertex;
  const double* guess = near ? vertex.parameter.data() : nullptr;
  switch (vertex.carrier.dimension) {
    case 0:
      break;
    case 1: {
      const CurvePoint found = boundary_.project_to_edge(vertex.carrier.number, target, guess);
      result.position = found.position;
      result.direction = found.tangent;
      result.parameter = {found.t, 0.0};
      break;
    }
    case 2: {
      const SurfacePoint found = boundary_.project_to_face(vertex.carrier.number, target, guess);
      result.position = found.position;
      result.direction = found.normal;
      result.parameter = {found.u, found.v};
      break;
    }
    default:
      result.position = target;
  }
  return result;
}

std::optional<Vertex> MeshState::moved(const Vertex& vertex, const Vec3& target) const {
  if (vertex.is_fixed()) return vertex;
  Vertex result = carried(vertex, target);
  if (is_at_border(result, target) || !evaluate(result)) return std::nullopt;
  return result;
}

std::optional<Vertex> MeshState::on_edge(int a, int b, int label, double s) const {
  Vertex result;
  result.size = vertices[a].size + s * (vertices[b].size - vertices[a].size);
  result.stretch = vertices[a].stretch + s * (vertices[b].stretch - vertices[a].stretch);
  if (const int edge = complex.crease(a, b)) {
    result.carrier = {1, edge};
  } else if (label) {
    result.carrier = {2, label};
  } else {
    result.carrier = {3, solid_around(a, b)};
  }
  const Vec3 target = position(a) + s * (position(b) - position(a));
  result = carried(result, target, false);
  if (is_at_border(result, target) || !evaluate(result)) return std::nullopt;
  return result;
}

int MeshState::solid_around(int a, int b) const {
  for (int v : {a, b})
    if (vertices[v].carrier.dimension == 3) return vertices[v].carrier.number;
  return complex.tet(complex.find_edge(a, b)).solid;
}

double chord_error(const MeshState& state, const Vertex& a, const Vertex& b, int label) {
  const Vec3 chord = b.position - a.position;
  const auto seen_from = [&](const Vertex& end) {
    return end.carrier.dimension == 2 ? 0.25 * std::abs(end.direction.dot(chord)) : 0.0;
  };
  if (a.carrier.dimension == 1 && b.carrier.dimension == 1 && a.carrier.number == b.carrier.number) {
    // Along their edge, and not across a face that it goes around.
    constexpr double kAlong = 0.5;
    const double aside = std::max(a.direction.cross(chord).norm(), b.direction.cross(chord).norm());
    if (aside < kAlong * chord.norm()) return 0.25 * aside;
  }
  if (a.carrier.dimension == 2 || b.carrier.dimension == 2) return std::max(seen_from(a), seen_from(b));
  const Vec3 middle = 0.5 * (a.position + b.position);
  return (state.boundary().project_to_face(label, middle).position - middle).norm();
}

double crease_error(const MeshState& state, const Vertex& a, const Vertex& b, int edge) {
  const Vec3 middle = 0.5 * (a.position + b.position);
  const double* guess = a.carrier.dimension == 1   ? a.parameter.data()
                        : b.carrier.dimension == 1 ? b.parameter.data()
                                                   : nullptr;
  return (state.boundary().project_to_edge(edge, middle, guess).position - middle).norm();
}

void limit_growth(MeshState& state, double growth) {
  // Each pass carries a limit along the order of the tetrahedra, the next one back.
  const int slots = state.complex.slots();
  bool changed = true;
  for (bool forward = true; changed; forward = !forward) {
    changed = false;
    for (int i = 0; i < slots; ++i) {
      const Tet& tet = state.complex.tet(forward ? i : slots - 1 - i);
      if (!tet.alive()) continue;
      for (const auto& edge : kEdgeVertices) {
        Vertex &a = state.vertices[tet.vertex[edge[0]]], &b = state.vertices[tet.vertex[edge[1]]];
        Vertex &small = a.size < b.size ? a : b, &large = a.size < b.size ? b : a;
        // Most edges are far from the limit, and need no root.
        const double more = large.size - small.size, squared = (a.position - b.position).squaredNorm();
        if (more * more <= growth * growth * squared) continue;
        const double limit = small.size + growth * std::sqrt(squared);
        if (large.size > limit * (1.0 + 1e-6)) {
          large.size = limit;
          changed = true;
        }
      }
    }
  }
}

double allowed_chord_error(const MeshState& state, const Vertex& a, const Vertex& b) {
  constexpr double kPartOfSize = 0.15, kPartOfLength = 0.1;
  return std::min({state.chord_limit, kPartOfSize * std::min(a.size, b.size),
                   kPartOfLength * (a.position - b.position).norm()});
}

bool is_at_border(const Vertex& vertex, const Vec3& target) {
  if (vertex.carrier.dimension != 2 || vertex.direction.isZero()) return false;
  constexpr double kRounding = 1e-9, kLeastSine = 0.5;
  const Vec3 way = target - vertex.position;
  return way.norm() > kRounding * target.norm() &&
         way.cross(vertex.direction).norm() > kLeastSine * way.norm();
}

bool stays_positive(const MeshState& state, int v, const Vec3& place, const std::vector<int>& star) {
  return std::all_of(star.begin(), star.end(), [&](int t) {
    const std::array<int, 4>& index = state.complex.tet(t).vertex;
    const auto at = [&](int i) -> const Vec3& { return index[i] == v ? place : state.position(index[i]); };
    return is_positive(at(0), at(1), at(2), at(3));
  });
}

bool faces_outward(const MeshState& state, const Vertex& a, const Vertex& b, const Vertex& c, int label) {
  constexpr double kLeastCosine = 0.5;
  const Vec3 normal = area_vector(a.position, b.position, c.position);
  const double least = kLeastCosine * normal.norm();
  bool told = false;
  for (const Vertex* v : {&a, &b, &c}) {
    if (v->carrier.dimension != 2 || v->direction.isZero()) continue;
    if (!(normal.dot(v->direction) > least)) return false;
    told = true;
  }
  if (told) return true;
  const Vec3 centre = (a.position + b.position + c.position) / 3.0;
  const Vec3 outward = state.boundary().project_to_face(label, centre).normal;
  return outward.isZero() || normal.dot(outward) > least;
}

bool may_move(const MeshState& state, int v, const Vertex& moved, const std::vector<int>& star) {
  const Vertex& old = state.vertices[v];
  if (state.min_size > 0.0 && !keeps_min_size(state, v, moved.position, star)) return false;
  if (old.carrier.dimension == 3) return true;
  for (int t : star) {
    const Tet& tet = state.complex.tet(t);
    const int own = tet.index_of(v);
    for (int face = 0; face < 4; ++face) {
      if (!tet.label[face] || face == own) continue;
      const auto at = [&](int k, const Vertex& own_vertex) -> const Vertex& {
        const int w = tet.vertex[kFaceVertices[face][k]];
        return w == v ? own_vertex : state.vertices[w];
      };
      if (!faces_outward(state, at(0, moved), at(1, moved), at(2, moved), tet.label[face]) &&
          faces_outward(state, at(0, old), at(1, old), at(2, old), tet.label[face]))
        return false;
      for (int i = 0; i < 4; ++i) {
        if (i == face || i == own) continue;
        const Vertex& end = state.vertices[tet.vertex[i]];
        const double error = chord_error(state, moved, end, tet.label[face]);
        if (error > allowed_chord_error(state, old, end) &&
            error > chord_error(state, old, end, tet.label[face]))
          return false;
      }
    }
  }
  return true;
}

bool MeshState::may_be_made(double squared_length, const std::vector<int>& in_place_of) const {
  if (squared_length >= min_size * min_size) return true;
  return std::any_of(in_place_of.begin(), in_place_of.end(),
                     [&](int t) { return shortest_edge_squared(complex.tet(t).vertex) <= squared_length; });
}

bool MeshState::may_be_made(const std::vector<NewTet>& made, const std::vector<int>& in_place_of) const {
  if (min_size == 0.0) return true;
  double shortest = std::numeric_limits<double>::infinity();
  for (const NewTet& tet : made) shortest = std::min(shortest, shortest_edge_squared(tet.vertex));
  return may_be_made(shortest, in_place_of);
}

double MeshState::shortest_edge_squared(const std::array<int, 4>& v) const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : kEdgeVertices)
    shortest = std::min(shortest, (position(v[i]) - position(v[j])).squaredNorm());
  return shortest;
}

int MeshState::label_at(int a, int b, const EdgeRing& ring) const {
  for (int t : ring.tet) {
    const Tet& tet = complex.tet(t);
    for (int i = 0; i < 4; ++i)
      if (tet.vertex[i] != a && tet.vertex[i] != b && tet.label[i]) return tet.label[i];
  }
  return 0;
}

int MeshState::add(const Vertex& vertex) {
  vertices.push_back(vertex);
  return complex.add_vertex();
}

void MeshState::sort_by_place() {
  std::vector<int> order;
  order.reserve(vertices.size());
  for (int v = 0; v < complex.vertex_slots(); ++v)
    if (complex.tet_at(v) >= 0) order.push_back(v);
  using Traits = CGAL::Spatial_sort_traits_adapter_3<PlaceTraits, PlaceOf>;
  CGAL::hilbert_sort(order.begin(), order.end(), Traits(PlaceOf{&vertices}));
  std::vector<int> place(vertices.size(), -1);
  std::vector<Vertex> sorted;
  sorted.reserve(order.size());
  for (int v : order) {
    place[v] = static_cast<int>(sorted.size());
    sorted.push_back(std::move(vertices[v]));
  }
  vertices = std::move(sorted);
  complex.renumber(place);
}

TetMesh MeshState::to_tet_mesh(std::vector<int>* vertex_order) const {
  TetMesh mesh;
  std::vector<int> number(vertices.size(), -1);
  if (vertex_order) vertex_order->clear();
  for (int v = 0; v < complex.vertex_slots(); ++v) {
    if (complex.tet_at(v) < 0) continue;
    number[v] = static_cast<int>(mesh.points.size());
    mesh.points.push_back(position(v));
    mesh.carriers.push_back(vertices[v].carrier);
    if (vertex_order) vertex_order->push_back(v);
  }
  for (int t = 0; t < complex.slots(); ++t) {
    const Tet& tet = complex.tet(t);
    if (!tet.alive()) continue;
    mesh.tets.push_back(
        {number[tet.vertex[0]], number[tet.vertex[1]], number[tet.vertex[2]], number[tet.vertex[3]]});
    mesh.tet_solids.push_back(tet.solid);
    for (int i = 0; i < 4; ++i) {
      // An interface is written once, from the solid with the lower number.
      const int other = tet.neighbour[i];
      if (!tet.label[i] || (other >= 0 && complex.tet(other).solid < tet.solid)) continue;
      const int* face = kFaceVertices[i];
      mesh.triangles.push_back(
          {number[tet.vertex[face[0]]], number[tet.vertex[face[1]]], number[tet.vertex[face[2]]]});
      mesh.triangle_faces.push_back(tet.label[i]);
    }
  }
  for (const auto& [a, b, edge] : complex.creases()) {
    mesh.edges.push_back({number[a], number[b]});
    mesh.edge_edges.push_back(edge);
  }
  return mesh;
}

}  // namespace fgmesh
