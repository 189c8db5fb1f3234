// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/solid_materials.hpp"

#include <algorithm>

namespace fgmesh {
namespace {

using Lists = std::vector<std::vector<int>>;

void add(Lists& lists, int number, int entry) {
  if (number >= static_cast<int>(lists.size())) lists.resize(number + 1);
  std::vector<int>& list = lists[number];
  const auto place = std::lower_bound(list.begin(), list.end(), entry);
  if (place == list.end() || *place != entry) list.insert(place, entry);
}

const std::vector<int>& list_of(const std::array<Lists, 4>& lists, const Carrier& carrier) {
  static const std::vector<int> first_material{0};  // of what lies outside everything
  const Lists& own = lists[carrier.dimension];
  const bool known = carrier.number < static_cast<int>(own.size()) && !own[carrier.number].empty();
  return known ? own[carrier.number] : first_material;
}

}  // namespace

SolidMaterials::SolidMaterials(const std::vector<const CompositionField*>& fields,
                               const SampledBoundary& samples) {
  for (const CompositionField* field : fields) {
    const auto known = std::find(fields_.begin(), fields_.end(), field);
    of_solid_.push_back(static_cast<int>(known - fields_.begin()));
    if (known == fields_.end()) fields_.push_back(field);
  }
  if (count() == 1) return;
  std::vector<int> corner_at(samples.points.size(), 0);
  for (const SampledBoundary::Corner& corner : samples.corners) corner_at[corner.point] = corner.vertex;
  for (std::size_t t = 0; t < samples.triangles.size(); ++t) {
    for (int solid : samples.triangle_solids[t]) {
      if (solid == 0) continue;
      add(solids_[2], samples.triangle_face[t], solid);
      for (int point : samples.triangles[t])
        if (corner_at[point]) add(solids_[0], corner_at[point], solid);
    }
  }
  for (const SampledBoundary::Curve& curve : samples.curves)
    for (int face : curve.faces)
      for (int solid : solids_[2][face]) add(solids_[1], curve.edge, solid);
  for (int solid = 1; solid <= samples.solid_count; ++solid) add(solids_[3], solid, solid);
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (const std::vector<int>& solids : solids_[dimension]) {
      std::vector<int>& materials = materials_[dimension].emplace_back();
      for (int solid : solids)
        if (std::find(materials.begin(), materials.end(), of_solid(solid)) == materials.end())
          materials.push_back(of_solid(solid));
    }
  }
}

const std::vector<int>& SolidMaterials::at(const Carrier& carrier) const {
  return list_of(materials_, carrier);
}

const std::vector<int>& SolidMaterials::solids_at(const Carrier& carrier) const {
  return list_of(solids_, carrier);
}

}  // namespace fgmesh
