// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/composition_field.hpp"
#include "core/reference.hpp"

namespace fgmesh {

/// Where a material's coordinates are measured: columns of `rotation` are the frame's axes.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

/// A functionally graded material: the volume fractions of all constituents but the last are formulas over
/// x y z r theta d, named parameters and distances to references, the last is the remainder (paper,
/// equation 2.1). Immutable, so safe to share between threads.
class Material final : public CompositionField {
 public:
  /// Throws FormulaError for a text that is no formula, InvalidInput for parameters with forbidden names.
  Material(const std::vector<std::string>& fractions, const std::map<std::string, double>& parameters = {},
           const Frame& frame = {}, const std::vector<Reference>& references = {});

  int constituents() const override;
  void evaluate(const Vec3* points, std::size_t count, double* fractions) const override;
  void evaluate(const Vec3* points, std::size_t count, double* fractions, Vec3* gradients) const override;
  void bounds(const Box& box, double* low, double* high) const override;

  /// The fractions where the references have not been read, but the distances to them at the points are
  /// known: one row a point, signed for solids.
  void evaluate_at(const Vec3* points, const double* distances, std::size_t count, double* fractions) const;

  const std::vector<std::string>& fractions() const;
  const std::map<std::string, double>& parameters() const;
  const Frame& frame() const;
  const std::vector<Reference>& references() const;

  Material(Material&&) noexcept;
  ~Material() override;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace fgmesh
