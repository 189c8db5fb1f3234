// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/point_variables.hpp"

#include <cmath>

namespace fgmesh {

void PointVariables::values(Variable variable, std::size_t first, std::size_t count, double* out) const {
  const auto reference = to_reference(variable);
  if (!reference) return coordinates_.values(variable, first, count, out);
  if (distances_)
    for (std::size_t i = 0; i < count; ++i)
      out[i] = distances_[(first + i) * references_.size() + reference->index];
  else
    references_[reference->index].distance->evaluate(points_ + first, count, out);
  if (reference->is_signed) return;
  for (std::size_t i = 0; i < count; ++i) out[i] = std::abs(out[i]);
}

void PointVariables::duals(Variable variable, std::size_t first, std::size_t count, std::size_t stride,
                           double* out) const {
  const auto reference = to_reference(variable);
  if (!reference) return coordinates_.duals(variable, first, count, stride, out);
  const Reference& source = references_[reference->index];
  std::vector<Vec3> gradients(count);
  source.distance->evaluate(points_ + first, count, out, gradients.data());
  for (std::size_t i = 0; i < count; ++i) {
    // On the boundary of a solid the distance without a sign has the slope of its inside, where material is.
    const bool turned = source.is_solid && !reference->is_signed && out[i] <= 0.0;
    if (turned) out[i] = -out[i];
    for (int axis = 0; axis < 3; ++axis) {
      out[(axis + 1) * stride + i] = turned ? -gradients[i][axis] : gradients[i][axis];
    }
  }
}

Interval variable_bounds(const Frame& frame, const std::vector<Reference>& references, const Box& box,
                         Variable variable) {
  const auto reference = to_reference(variable);
  if (!reference) return coordinate_bounds(frame, box, variable);
  if (!(box.low.array() <= box.high.array()).all()) return Interval::empty();
  Interval distance{};
  references[reference->index].distance->bounds(box, distance.low, distance.high);
  return reference->is_signed ? distance : abs(distance);
}

}  // namespace fgmesh
