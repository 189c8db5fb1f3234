// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "core/run_control.hpp"
#include "core/tet_mesh.hpp"

namespace fgmesh {

struct SamplingOptions {
  /// Distance of a sample triangle to its face that is aimed at, mm; 0: the diagonal of the part / 2000.
  /// OpenCASCADE keeps it on edges and exceeds it up to twofold on balls, fourfold on tori.
  double deflection = 0.0;
  /// Largest angle between neighbouring sample triangles of a face, radians.
  double angle = 0.2;
};

/// Which parts of the shape that was given each part of solids made separate comes from; of part N at N - 1.
struct Origins {
  int solid_count = 0;                     ///< of the shape given
  std::vector<int> solids;                 ///< SolidN, ascending
  std::vector<std::vector<int>> faces;     ///< FaceN, ascending; several where faces coincided
  std::vector<std::vector<int>> edges;     ///< EdgeN; none where the edge is new
  std::vector<std::vector<int>> vertices;  ///< VertexN; none where the vertex is new
};

/// A checked OpenCASCADE shape behind an interface that shows no OCCT: one or more valid, closed solids that
/// meet in shared faces only, numbered as FreeCAD numbers them (TopExp::MapShapes order of the whole shape).
/// Solids that touch otherwise, overlap or are nested are made so, and then have numbers of their own: see
/// origins().
class BrepModel final : public BoundaryGeometry {
 public:
  /// Reads the text of a BREP or STEP file (told apart by its first bytes) and checks it.
  /// Throws InvalidInput where the text is neither, is empty or cut short; GeometryError where the shape
  /// holds no solid, an open shell, a solid without volume or an invalid sub-shape, naming it.
  static BrepModel from_text(const std::string& text, RunControl& control);

  /// Samples the boundary finely, and prepares the projections: it must come before the first of these. A
  /// finer deflection than asked is taken where the faces need it (walls thinner than the deflection). Throws
  /// GeometryError that names a face which cannot be triangulated; Cancelled.
  SampledBoundary sample(const SamplingOptions& options, RunControl& control);

  // A number that bounds no solid, or a projection before sample(), is a std::out_of_range.
  SurfacePoint project_to_face(int face, const Vec3& p, const double* guess_uv = nullptr) const override;
  CurvePoint project_to_edge(int edge, const Vec3& p, const double* guess_t = nullptr) const override;
  Vec3 vertex_position(int vertex) const override;
  bool contains(const Vec3& p, int solid = 0, bool with_boundary = true) const override;

  /// Empty where every number is that of the shape given.
  const Origins& origins() const;
  /// The solids of the shape given, and which of them SolidN belongs to.
  int given_solid_count() const;
  int given_solid(int solid) const;

  int solid_count() const;
  int face_count() const;                      ///< highest FaceN
  int edge_count() const;                      ///< highest EdgeN
  int vertex_count() const;                    ///< highest VertexN
  double volume() const;                       ///< of all solids, from their true faces, mm^3
  const std::vector<double>& volumes() const;  ///< of each solid
  Box bounds() const;                          ///< tight around the true faces

  /// What was put right or left out while reading, in words for the user.
  const std::vector<std::string>& notes() const;

  /// Pairs of faces, edges or vertices of the solids that OpenCASCADE finds to cross or touch each other,
  /// though they share no edge or vertex there. Slow: for a verdict where meshing failed.
  std::vector<std::array<Carrier, 2>> self_interferences(RunControl& control) const;

  BrepModel(BrepModel&&) noexcept;
  ~BrepModel() override;

 private:
  struct State;
  explicit BrepModel(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace fgmesh
