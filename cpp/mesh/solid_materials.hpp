// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/boundary_geometry.hpp"
#include "core/composition_field.hpp"
#include "core/tet_mesh.hpp"

namespace fgmesh {

/// The materials of the solids, and which of them meet where. Materials are told by their index; solids with
/// the same field have the same material.
class SolidMaterials {
 public:
  /// One for all solids.
  explicit SolidMaterials(const CompositionField& field) : fields_{&field} {}

  /// `fields` holds that of SolidN at n - 1.
  SolidMaterials(const std::vector<const CompositionField*>& fields, const SampledBoundary& samples);

  int count() const { return static_cast<int>(fields_.size()); }
  const CompositionField& field(int material) const { return *fields_[material]; }
  int of_solid(int solid) const { return count() == 1 ? 0 : of_solid_[solid - 1]; }

  /// The materials that meet at a part of the shape, that of the lowest solid first.
  const std::vector<int>& at(const Carrier& carrier) const;
  /// The solids there, ascending; not known where there is but one material.
  const std::vector<int>& solids_at(const Carrier& carrier) const;

 private:
  std::vector<const CompositionField*> fields_;
  std::vector<int> of_solid_;
  // Of each carrier, by its dimension and its number.
  std::array<std::vector<std::vector<int>>, 4> solids_, materials_;
};

}  // namespace fgmesh
