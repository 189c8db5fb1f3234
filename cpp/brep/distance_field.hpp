// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "brep/nearest_point.hpp"
#include "brep/piece_tree.hpp"
#include "brep/reference_pieces.hpp"
#include "core/scalar_field.hpp"

namespace fgmesh::brep {

/// Distance to a part of a shape: samples tell where the nearest point may be, the true faces and edges where
/// it is. Immutable, so safe to share between threads.
class DistanceField final : public ScalarField {
 public:
  /// `solid`: number of the solid whose boundary the pieces are, to give distances a sign; 0 for none.
  DistanceField(std::shared_ptr<const MeasuredShape> measured, std::vector<Piece> pieces, int solid);

  void evaluate(const Vec3* points, std::size_t count, double* values) const override;

  /// On a face itself the gradient is that of the outside (solids) or of the inside (faces); on an edge or
  /// vertex zero.
  void evaluate(const Vec3* points, std::size_t count, double* values, Vec3* gradients) const override;

  void bounds(const Box& box, double& low, double& high) const override;

  /// Of second order in the size of a tetrahedron that is clear of the reference.
  void tet_bounds(const Corners& tet, double& low, double& high) const override;

 private:
  struct Found;
  struct Scratch;

  Found nearest(const Vec3& p, Scratch& scratch) const;
  void look_at_face(const Vec3& p, const PieceTree::Candidate& candidate, Found& found,
                    Scratch& scratch) const;
  void look_at_edge(const Vec3& p, const Piece& piece, Found& found, Scratch& scratch) const;
  Vec3 outward(const Found& found) const;
  Vec3 face_normal(int face, const Vec3& normal) const;
  double measure(const Vec3& p, Scratch& scratch, Vec3* gradient) const;

  std::shared_ptr<const MeasuredShape> measured_;
  PieceTree tree_;
  int solid_ = 0;
  std::uint64_t id_;      ///< no other field had it before
  double size_ = 0.0;     ///< of the shape, mm
  NearestPoint samples_;  ///< of the boundary, for a solid
  std::vector<Vec3> sample_normals_;
};

}  // namespace fgmesh::brep
