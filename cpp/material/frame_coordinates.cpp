// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/frame_coordinates.hpp"

#include <cmath>
#include <optional>
#include <type_traits>

namespace fgmesh {
namespace {

// The same expressions serve points (double) and boxes (Interval), in the same order of operations: this
// makes a box's bounds hold for the rounded values too.

double square(double value) { return value * value; }

template <class Number>
struct Local {
  const Frame& frame;
  Number offset[3];  // from the frame's origin, along the world's axes

  Number along(int axis) const {
    const auto term = [&](int i) { return constant(frame.rotation(i, axis)) * offset[i]; };
    return term(0) + term(1) + term(2);
  }

  Number value(Variable variable) const {
    using std::atan2;
    using std::sqrt;
    switch (variable) {
      case Variable::kX:
        return along(0);
      case Variable::kY:
        return along(1);
      case Variable::kZ:
        return along(2);
      case Variable::kRadius:
        return sqrt(square(along(0)) + square(along(1)));
      case Variable::kAngle:
        // Adding zero turns -0 into +0, so that the angle is in (-pi, pi] and not twice on the cut.
        return atan2(along(1) + constant(0.0), along(0) + constant(0.0));
      case Variable::kDistance:
        break;
    }
    return sqrt(square(offset[0]) + square(offset[1]) + square(offset[2]));
  }

  static Number constant(double value) {
    if constexpr (std::is_same_v<Number, double>) {
      return value;
    } else {
      return Number::point(value);
    }
  }
};

Local<double> local(const Frame& frame, const Vec3& point) {
  return {frame, {point[0] - frame.origin[0], point[1] - frame.origin[1], point[2] - frame.origin[2]}};
}

/// In the world's axes.
Vec3 gradient(const Local<double>& local, Variable variable, double value) {
  const auto axis = [&](int i) -> Vec3 { return local.frame.rotation.col(i); };
  switch (variable) {
    case Variable::kX:
      return axis(0);
    case Variable::kY:
      return axis(1);
    case Variable::kZ:
      return axis(2);
    case Variable::kRadius:
      if (value == 0.0) return Vec3::Zero();
      return (local.along(0) / value) * axis(0) + (local.along(1) / value) * axis(1);
    case Variable::kAngle: {
      const double x = local.along(0), y = local.along(1), r = std::hypot(x, y);
      if (r == 0.0) return Vec3::Zero();
      return (x / r / r) * axis(1) - (y / r / r) * axis(0);
    }
    case Variable::kDistance:
      break;
  }
  if (value == 0.0) return Vec3::Zero();
  return Vec3(local.offset[0], local.offset[1], local.offset[2]) / value;
}

}  // namespace

void FrameCoordinates::values(Variable variable, std::size_t first, std::size_t count, double* out) const {
  for (std::size_t i = 0; i < count; ++i) out[i] = local(frame_, points_[first + i]).value(variable);
}

void FrameCoordinates::duals(Variable variable, std::size_t first, std::size_t count, std::size_t stride,
                             double* out) const {
  for (std::size_t i = 0; i < count; ++i) {
    const Local<double> here = local(frame_, points_[first + i]);
    out[i] = here.value(variable);
    const Vec3 slope = gradient(here, variable, out[i]);
    for (int axis = 0; axis < 3; ++axis) out[(axis + 1) * stride + i] = slope[axis];
  }
}

namespace {

/// Nothing where the box is empty.
std::optional<Local<Interval>> local(const Frame& frame, const Box& box) {
  Local<Interval> everywhere{frame, {}};
  for (int i = 0; i < 3; ++i) {
    const Interval side{box.low[i], box.high[i]};
    if (side.is_empty()) return std::nullopt;
    everywhere.offset[i] = side - Interval::point(frame.origin[i]);
  }
  return everywhere;
}

/// The slopes of the length of a vector in a plane or in space along its components: each component by the
/// length. It rises with the component, and the others draw it towards zero.
void length_slopes(const Interval* components, int count, Interval* slopes) {
  const auto at = [](double component, double others) {
    return component == 0.0 ? 0.0 : component / std::sqrt(component * component + others);
  };
  Interval squares[3];
  for (int i = 0; i < count; ++i) squares[i] = square(components[i]);
  for (int i = 0; i < count; ++i) {
    Interval rest = squares[(i + 1) % count];
    if (count == 3) rest = rest + squares[(i + 2) % count];
    const Interval& component = components[i];
    // Where the length may vanish its direction is any.
    slopes[i] = rest.low == 0.0 && component.contains(0.0)
                    ? Interval{-1.0, 1.0}
                    : widened(at(component.low, component.low > 0.0 ? rest.high : rest.low),
                              at(component.high, component.high > 0.0 ? rest.low : rest.high));
  }
}

}  // namespace

Interval coordinate_bounds(const Frame& frame, const Box& box, Variable variable) {
  const std::optional<Local<Interval>> everywhere = local(frame, box);
  return everywhere ? everywhere->value(variable) : Interval::empty();
}

DualInterval coordinate_dual_bounds(const Frame& frame, const Box& box, Variable variable) {
  const std::optional<Local<Interval>> everywhere = local(frame, box);
  DualInterval result;
  result.value = everywhere ? everywhere->value(variable) : Interval::empty();
  if (!everywhere) return result;
  if (variable == Variable::kDistance) {
    length_slopes(everywhere->offset, 3, result.slope.data());
    return result;
  }
  const auto column = [&](int axis, int i) { return Interval::point(frame.rotation(i, axis)); };
  if (variable != Variable::kRadius && variable != Variable::kAngle) {
    for (int i = 0; i < 3; ++i) result.slope[i] = column(static_cast<int>(variable), i);
    return result;
  }
  const Interval across[] = {everywhere->along(0), everywhere->along(1)};
  const Interval &x = across[0], &y = across[1];
  Interval slopes[2];
  length_slopes(across, 2, slopes);
  auto& [by_x, by_y] = slopes;
  if (variable == Variable::kAngle) {
    const Interval radius = sqrt(square(x) + square(y));
    const bool jumps = radius.low == 0.0 || (x.low < 0.0 && y.low < 0.0 && y.high >= 0.0);
    const Interval turned = jumps ? Interval::whole() : -by_y / radius;
    by_y = jumps ? Interval::whole() : by_x / radius;
    by_x = turned;
  }
  for (int i = 0; i < 3; ++i) result.slope[i] = by_x * column(0, i) + by_y * column(1, i);
  return result;
}

}  // namespace fgmesh
