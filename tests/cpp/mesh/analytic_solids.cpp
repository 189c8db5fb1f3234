// SPDX-License-Identifier: GPL-3.0-or-later
#include "analytic_solids.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "box_grid.hpp"

namespace fgmesh::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSlack = 1e-9;  // of the size, for contains()

void bound(SampledBoundary& samples, double volume, int faces) {
  samples.bounds = {samples.points.front(), samples.points.front()};
  for (const Vec3& p : samples.points) {
    samples.bounds.low = samples.bounds.low.cwiseMin(p);
    samples.bounds.high = samples.bounds.high.cwiseMax(p);
  }
  samples.triangle_solids.assign(samples.triangles.size(), {1, 0});
  samples.volume = volume;
  samples.solid_count = 1;
  samples.face_count = faces;
}

Vec3 on_circle(double radius, double angle, double z) {
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace

SurfacePoint BoxSolid::project_to_face(int face, const Vec3& p, const double*) const {
  const int axis = (face - 1) / 2, side = (face - 1) % 2;
  SurfacePoint found;
  found.position = p.cwiseMax(box_.low).cwiseMin(box_.high);
  found.position[axis] = side ? box_.high[axis] : box_.low[axis];
  found.normal[axis] = side ? 1.0 : -1.0;
  found.u = found.position[(axis + 1) % 3];
  found.v = found.position[(axis + 2) % 3];
  return found;
}

CurvePoint BoxSolid::project_to_edge(int edge, const Vec3& p, const double*) const {
  const int axis = (edge - 1) / 4, first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
  CurvePoint found;
  found.position = p.cwiseMax(box_.low).cwiseMin(box_.high);
  found.position[first] = (edge - 1) & 2 ? box_.high[first] : box_.low[first];
  found.position[second] = (edge - 1) & 1 ? box_.high[second] : box_.low[second];
  found.tangent[axis] = 1.0;
  found.t = found.position[axis];
  return found;
}

Vec3 BoxSolid::vertex_position(int vertex) const {
  Vec3 p;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = (vertex - 1) >> (2 - axis) & 1 ? box_.high[axis] : box_.low[axis];
  return p;
}

bool BoxSolid::contains(const Vec3& p, int, bool with_boundary) const {
  const double slack = (with_boundary ? kSlack : -kSlack) * box_.diagonal();
  return ((p - box_.low).array() >= -slack).all() && ((box_.high - p).array() >= -slack).all();
}

SampledBoundary BoxSolid::samples() const {
  constexpr int kCells = 10;
  const TetMesh grid = box_grid(box_, {kCells, kCells, kCells});
  SampledBoundary samples;
  std::vector<int> number(grid.points.size(), -1);
  for (std::size_t v = 0; v < grid.points.size(); ++v) {
    const Carrier& carrier = grid.carriers[v];
    if (carrier.dimension == 3) continue;
    number[v] = static_cast<int>(samples.points.size());
    samples.points.push_back(grid.points[v]);
    if (carrier.dimension == 0) samples.corners.push_back({carrier.number, number[v]});
  }
  for (std::size_t t = 0; t < grid.triangles.size(); ++t) {
    const auto& [a, b, c] = grid.triangles[t];
    samples.triangles.push_back({number[a], number[b], number[c]});
    samples.triangle_face.push_back(grid.triangle_faces[t]);
  }
  for (int edge = 1; edge <= 12; ++edge) {
    SampledBoundary::Curve curve;
    curve.edge = edge;
    const int axis = (edge - 1) / 4, first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    curve.faces = {1 + 2 * first + ((edge - 1) & 2 ? 1 : 0), 1 + 2 * second + ((edge - 1) & 1)};
    // Along an axis the grid's points are in order.
    for (std::size_t v = 0; v < grid.points.size(); ++v) {
      if (number[v] < 0 || project_to_edge(edge, grid.points[v]).position != grid.points[v]) continue;
      curve.points.push_back(number[v]);
      curve.parameters.push_back(grid.points[v][axis]);
    }
    samples.curves.push_back(curve);
  }
  bound(samples, volume(), 6);
  return samples;
}

SurfacePoint BallSolid::project_to_face(int, const Vec3& p, const double*) const {
  SurfacePoint found;
  found.normal = p.norm() > 0.0 ? Vec3(p.normalized()) : Vec3::UnitX();
  found.position = radius_ * found.normal;
  found.u = std::atan2(p.y(), p.x());
  found.v = std::asin(found.normal.z());
  return found;
}

CurvePoint BallSolid::project_to_edge(int, const Vec3&, const double*) const {
  throw std::out_of_range("a ball has no edge to project to");
}

Vec3 BallSolid::vertex_position(int) const { throw std::out_of_range("a ball has no vertex"); }

bool BallSolid::contains(const Vec3& p, int, bool with_boundary) const {
  return p.norm() <= radius_ * (1.0 + (with_boundary ? kSlack : -kSlack));
}

double BallSolid::volume() const { return 4.0 / 3.0 * kPi * std::pow(radius_, 3); }

SampledBoundary BallSolid::samples() const {
  // An octahedron whose triangles are cut in four again and again, blown up.
  SampledBoundary samples;
  samples.points = {Vec3::UnitX(),  -Vec3::UnitX(), Vec3::UnitY(),
                    -Vec3::UnitY(), Vec3::UnitZ(),  -Vec3::UnitZ()};
  samples.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                       {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < 5; ++level) {
    std::map<std::pair<int, int>, int> middle_of;
    const auto middle = [&](int a, int b) {
      const auto [place, fresh] =
          middle_of.emplace(std::minmax(a, b), static_cast<int>(samples.points.size()));
      if (fresh) samples.points.push_back((samples.points[a] + samples.points[b]).normalized());
      return place->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : samples.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& triangle : {std::array<int, 3>{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(triangle);
    }
    samples.triangles = finer;
  }
  for (Vec3& p : samples.points) p *= radius_;
  samples.triangle_face.assign(samples.triangles.size(), 1);
  bound(samples, volume(), 1);
  return samples;
}

SurfacePoint CylinderSolid::project_to_face(int face, const Vec3& p, const double*) const {
  SurfacePoint found;
  const double r = std::hypot(p.x(), p.y());
  if (face == 1) {
    found.normal = r > 0.0 ? Vec3(p.x() / r, p.y() / r, 0) : Vec3::UnitX();
    found.position = radius_ * found.normal;
    found.position.z() = std::clamp(p.z(), 0.0, height_);
    found.u = std::atan2(p.y(), p.x());
    found.v = found.position.z();
    return found;
  }
  found.position = p * std::min(1.0, radius_ / std::max(r, 1e-300));
  found.position.z() = face == 3 ? height_ : 0.0;
  found.normal = face == 3 ? Vec3::UnitZ() : Vec3(-Vec3::UnitZ());
  found.u = found.position.x();
  found.v = found.position.y();
  return found;
}

CurvePoint CylinderSolid::project_to_edge(int edge, const Vec3& p, const double*) const {
  CurvePoint found;
  found.t = std::atan2(p.y(), p.x());
  found.position = on_circle(radius_, found.t, edge == 2 ? height_ : 0.0);
  found.tangent = Vec3(-std::sin(found.t), std::cos(found.t), 0);
  return found;
}

Vec3 CylinderSolid::vertex_position(int vertex) const {
  return on_circle(radius_, 0.0, vertex == 2 ? height_ : 0.0);
}

bool CylinderSolid::contains(const Vec3& p, int, bool with_boundary) const {
  const double slack = (with_boundary ? kSlack : -kSlack) * (radius_ + height_);
  return std::hypot(p.x(), p.y()) <= radius_ + slack && p.z() >= -slack && p.z() <= height_ + slack;
}

double CylinderSolid::volume() const { return kPi * radius_ * radius_ * height_; }

double CylinderSolid::edge_length(int) const { return 2.0 * kPi * radius_; }

SampledBoundary CylinderSolid::samples() const {
  constexpr int kAround = 96, kRings = 12;
  SampledBoundary samples;
  const auto side = [](int ring, int i) { return ring * kAround + i % kAround; };
  for (int ring = 0; ring <= kRings; ++ring)
    for (int i = 0; i < kAround; ++i)
      samples.points.push_back(on_circle(radius_, 2.0 * kPi * i / kAround, height_ * ring / kRings));
  const auto add = [&](int a, int b, int c, int face) {
    samples.triangles.push_back({a, b, c});
    samples.triangle_face.push_back(face);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int i = 0; i < kAround; ++i) {
      add(side(ring, i), side(ring, i + 1), side(ring + 1, i + 1), 1);
      add(side(ring, i), side(ring + 1, i + 1), side(ring + 1, i), 1);
    }
  }
  const int below = static_cast<int>(samples.points.size()), above = below + 1;
  samples.points.push_back(Vec3(0, 0, 0));
  samples.points.push_back(Vec3(0, 0, height_));
  for (const int edge : {1, 2}) {
    SampledBoundary::Curve curve;
    curve.edge = edge;
    curve.faces = {1, edge + 1};
    for (int i = 0; i <= kAround; ++i) {
      curve.points.push_back(side(edge == 1 ? 0 : kRings, i));
      curve.parameters.push_back(2.0 * kPi * i / kAround);
    }
    for (int i = 0; i < kAround; ++i) {
      const int here = curve.points[i], next = curve.points[i + 1];
      if (edge == 1) add(below, next, here, 2);
      if (edge == 2) add(above, here, next, 3);
    }
    samples.curves.push_back(curve);
  }
  bound(samples, volume(), 3);
  return samples;
}

}  // namespace fgmesh::test
