// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vec3.hpp"

namespace fgmesh {

/// A point found on a face of the true boundary.
struct SurfacePoint {
  Vec3 position = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, out of the solid that owns the face; zero where undefined (a pole)
  double u = 0.0, v = 0.0;
};

/// A point found on an edge of the true boundary.
struct CurvePoint {
  Vec3 position = Vec3::Zero();
  Vec3 tangent = Vec3::Zero();  ///< unit
  double t = 0.0;
};

/// The true boundary of the solids, as the mesher sees it. Numbers are 1-based, as in FreeCAD's
/// FaceN, EdgeN, VertexN. All members are const and may be called from several threads.
class BoundaryGeometry {
 public:
  virtual ~BoundaryGeometry() = default;

  /// Closest point of face `face` to `p` within the part of the face near `p`. Without a guess the
  /// search starts at the nearest sample of the face; `guess_uv` (two numbers) saves that look-up
  /// where the caller knows the parameters of a point close by.
  virtual SurfacePoint project_to_face(int face, const Vec3& p, const double* guess_uv = nullptr) const = 0;

  /// Closest point of edge `edge` to `p`, clamped to the edge's ends.
  virtual CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess_t = nullptr) const = 0;

  virtual Vec3 vertex_position(int vertex) const = 0;

  /// True where `p` lies in SolidN, or in any solid where `solid` is 0; also on its boundary (within the
  /// shape's tolerance), if that is to count. Slow; for verdicts on single points, not for loops.
  virtual bool contains(const Vec3& p, int solid = 0, bool with_boundary = true) const = 0;
};

/// A fine triangulation of the boundary: what the initial mesh is made from. Points are welded, so
/// that triangles of neighbouring faces share them; degenerate triangles are dropped.
struct SampledBoundary {
  /// A B-Rep edge that mesh edges must follow: any edge but seams and degenerate ones. Edges between smoothly
  /// joined faces are kept too, as borders between labels.
  struct Curve {
    int edge = 0;                    ///< EdgeN
    std::vector<int> points;         ///< indices into `points`, in order; first == last where closed
    std::vector<double> parameters;  ///< parameter of each on the curve
    std::vector<int> faces;          ///< FaceN of the faces that meet here
  };

  struct Corner {
    int vertex = 0;  ///< VertexN
    int point = -1;  ///< index into `points`
  };

  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;        ///< counter-clockwise seen from outside the first solid
  std::vector<int> triangle_face;                   ///< FaceN
  std::vector<std::array<int, 2>> triangle_solids;  ///< SolidN behind and before the triangle; 0: outside
  std::vector<Curve> curves;
  /// Every vertex of the solids, on seams and at poles too, so that loads and supports find a node there.
  std::vector<Corner> corners;

  Box bounds;
  double volume = 0.0;  ///< of all solids, exact (from the B-Rep), mm^3
  int solid_count = 0;
  int face_count = 0;  ///< highest FaceN
};

}  // namespace fgmesh
