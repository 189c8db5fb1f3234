// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/frame_coordinates.hpp"

#include <cmath>
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

Interval coordinate_bounds(const Frame& frame, const Box& box, Variable variable) {
  Local<Interval> everywhere{frame, {}};
  for (int i = 0; i < 3; ++i) {
    const Interval side{box.low[i], box.high[i]};
    if (side.is_empty()) return Interval::empty();
    everywhere.offset[i] = side - Interval::point(frame.origin[i]);
  }
  return everywhere.value(variable);
}

}  // namespace fgmesh
