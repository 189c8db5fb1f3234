// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/point_variables.hpp"

#include <cmath>

#include "material/formula_operation.hpp"

namespace fgmesh {

void PointVariables::values(Variable variable, std::size_t first, std::size_t count, double* out) const {
  if (const auto table = to_table(variable)) return table_values(*tables_[*table], first, count, out);
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
  if (const auto table = to_table(variable)) return table_duals(*tables_[*table], first, count, stride, out);
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

void PointVariables::table_values(const SampledTable& table, std::size_t first, std::size_t count,
                                  double* out) const {
  double at[SampledTable::kMaxCoordinates];
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < table.axes().size(); ++axis)
      coordinates_.values(table.axes()[axis].coordinate, first + i, 1, at + axis);
    out[i] = table.value(at);
  }
}

void PointVariables::table_duals(const SampledTable& table, std::size_t first, std::size_t count,
                                 std::size_t stride, double* out) const {
  const std::size_t axes = table.axes().size();
  double at[SampledTable::kMaxCoordinates];
  double duals[SampledTable::kMaxCoordinates][4];  // value and gradient of each coordinate
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      coordinates_.duals(table.axes()[axis].coordinate, first + i, 1, 1, duals[axis]);
      at[axis] = duals[axis][0];
    }
    double gradient[3] = {};
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double slope = table.slope(at, axis);
      for (int k = 0; k < 3; ++k) gradient[k] += detail::chain(slope, duals[axis][k + 1]);
    }
    out[i] = table.value(at);
    // Infinite slopes may cancel each other.
    for (int k = 0; k < 3; ++k) out[(k + 1) * stride + i] = std::isnan(gradient[k]) ? 0.0 : gradient[k];
  }
}

namespace {

Interval table_bounds(const Frame& frame, const SampledTable& table, const Box& box) {
  Interval at[SampledTable::kMaxCoordinates];
  for (std::size_t axis = 0; axis < table.axes().size(); ++axis)
    at[axis] = coordinate_bounds(frame, box, table.axes()[axis].coordinate);
  return table.bounds(at);
}

DualInterval table_dual_bounds(const Frame& frame, const SampledTable& table, const Box& box) {
  DualInterval at[SampledTable::kMaxCoordinates];
  Interval places[SampledTable::kMaxCoordinates];
  const std::size_t axes = table.axes().size();
  for (std::size_t axis = 0; axis < axes; ++axis) {
    at[axis] = coordinate_dual_bounds(frame, box, table.axes()[axis].coordinate);
    places[axis] = at[axis].value;
  }
  DualInterval result;
  result.value = table.bounds(places);
  for (std::size_t axis = 0; axis < axes && !result.value.is_empty(); ++axis) {
    const Interval slope = table.slope_bounds(places, axis);
    for (int k = 0; k < 3; ++k) result.slope[k] = result.slope[k] + slope * at[axis].slope[k];
  }
  return result;
}

/// A distance changes by no more than the way that one goes.
DualInterval distance_bounds(const Reference& reference, const Corners& tet, bool is_signed) {
  DualInterval result;
  reference.distance->tet_bounds(tet, result.value.low, result.value.high);
  if (!is_signed) result.value = abs(result.value);
  result.slope.fill({-1.0, 1.0});
  return result;
}

}  // namespace

Interval variable_bounds(const Frame& frame, const std::vector<Reference>& references, const Tables& tables,
                         const Box& box, Variable variable) {
  if (const auto table = to_table(variable)) return table_bounds(frame, *tables[*table], box);
  const auto reference = to_reference(variable);
  if (!reference) return coordinate_bounds(frame, box, variable);
  if (!(box.low.array() <= box.high.array()).all()) return Interval::empty();
  Interval distance{};
  references[reference->index].distance->bounds(box, distance.low, distance.high);
  return reference->is_signed ? distance : abs(distance);
}

DualInterval variable_tet_bounds(const Frame& frame, const std::vector<Reference>& references,
                                 const Tables& tables, const Corners& tet, Variable variable) {
  if (const auto table = to_table(variable))
    return table_dual_bounds(frame, *tables[*table], box_around(tet));
  if (const auto reference = to_reference(variable))
    return distance_bounds(references[reference->index], tet, reference->is_signed);
  return coordinate_dual_bounds(frame, box_around(tet), variable);
}

}  // namespace fgmesh
