// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/composition_field.hpp"
#include "core/reference.hpp"
#include "material/sampled_table.hpp"

namespace fgmesh {

/// Where a material's coordinates are measured: columns of `rotation` are the frame's axes.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

/// Shared, since copies of a material are made while its references are read.
using Tables = std::vector<std::shared_ptr<const SampledTable>>;

/// A functionally graded material: the volume fractions of all constituents but the last are formulas over
/// x y z r theta d, named parameters, distances to references and values of tables, the last is the remainder
/// (paper, equation 2.1). Immutable, so safe to share between threads.
class Material final : public CompositionField {
 public:
  /// Throws FormulaError for a text that is no formula, InvalidInput for parameters with forbidden names.
  Material(const std::vector<std::string>& fractions, const std::map<std::string, double>& parameters = {},
           const Frame& frame = {}, const std::vector<Reference>& references = {}, const Tables& tables = {});

  int constituents() const override;
  void evaluate(const Vec3* points, std::size_t count, double* fractions) const override;
  void evaluate(const Vec3* points, std::size_t count, double* fractions, Vec3* gradients) const override;
  void bounds(const Box& box, double* low, double* high) const override;
  void tet_bounds(const Corners& tet, double* low, double* high, Vec3* slope_low,
                  Vec3* slope_high) const override;

  /// The fractions where the references have not been read, but the distances to them at the points are
  /// known: one row a point, signed for solids.
  void evaluate_at(const Vec3* points, const double* distances, std::size_t count, double* fractions) const;

  const std::vector<std::string>& fractions() const;
  const std::map<std::string, double>& parameters() const;
  const Frame& frame() const;
  const std::vector<Reference>& references() const;
  const Tables& tables() const;

  Material(Material&&) noexcept;
  ~Material() override;

 private:
  struct State;
  std::unique_ptr<const State> state_;
};

}  // namespace fgmesh
