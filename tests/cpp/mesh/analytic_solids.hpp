// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>

#include "core/boundary_geometry.hpp"

namespace fgmesh::test {

/// A solid whose boundary is known in closed form: what stands in for OpenCASCADE.
class AnalyticSolid : public BoundaryGeometry {
 public:
  /// A triangulation of the boundary, fine enough for meshes of a twentieth of the solid.
  virtual SampledBoundary samples() const = 0;
  virtual double volume() const = 0;
  /// Length of the edge with this number, mm.
  virtual double edge_length(int edge) const = 0;
  virtual int edge_count() const = 0;
};

/// An axis-aligned box, numbered as carrier_in_box() does.
class BoxSolid : public AnalyticSolid {
 public:
  explicit BoxSolid(const Box& box) : box_(box) {}
  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess_uv = nullptr) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess_t = nullptr) const override;
  Vec3 vertex_position(int vertex) const override;
  bool contains(const Vec3& p, int solid = 0, bool with_boundary = true) const override;
  SampledBoundary samples() const override;
  double volume() const override { return (box_.high - box_.low).prod(); }
  double edge_length(int edge) const override { return (box_.high - box_.low)[(edge - 1) / 4]; }
  int edge_count() const override { return 12; }

 protected:
  Box box_;
};

/// A ball about the origin: one face, no edge.
class BallSolid : public AnalyticSolid {
 public:
  explicit BallSolid(double radius) : radius_(radius) {}
  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess_uv = nullptr) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess_t = nullptr) const override;
  Vec3 vertex_position(int vertex) const override;
  bool contains(const Vec3& p, int solid = 0, bool with_boundary = true) const override;
  SampledBoundary samples() const override;
  double volume() const override;
  double edge_length(int) const override { return 0.0; }
  int edge_count() const override { return 0; }

 private:
  double radius_;
};

/// A cylinder about the z axis from z = 0: faces 1 the side, 2 below, 3 above; edges 1 below, 2 above.
class CylinderSolid : public AnalyticSolid {
 public:
  CylinderSolid(double radius, double height) : radius_(radius), height_(height) {}
  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess_uv = nullptr) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess_t = nullptr) const override;
  Vec3 vertex_position(int vertex) const override;
  bool contains(const Vec3& p, int solid = 0, bool with_boundary = true) const override;
  SampledBoundary samples() const override;
  double volume() const override;
  double edge_length(int edge) const override;
  int edge_count() const override { return 2; }

 private:
  double radius_, height_;
};

}  // namespace fgmesh::test
