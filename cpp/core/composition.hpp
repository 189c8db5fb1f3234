// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>

#include "core/vec3.hpp"

namespace fgmesh {

/// The material composition at a place: volume fractions of all constituents but the last, which is the
/// remainder (paper, equation 2.1).
using Composition = boost::container::small_vector<double, 1>;

/// Their gradients, 1/mm.
using CompositionGradient = boost::container::small_vector<Vec3, 1>;

/// The norm of a change of all fractions, of which `change` holds those of all but the last: the magnitude of
/// a difference between two compositions (paper, equation 2.3). Of two constituents that of one alone counts,
/// as in the paper's studies.
double magnitude(const Composition& change);

Composition change(const Composition& from, const Composition& to);

/// || M_a - M_b ||^2; of `Parts` as Composition holds them.
template <class Parts>
double squared_difference(const Parts& a, const Parts& b) {
  if (a.size() == 1) return (a[0] - b[0]) * (a[0] - b[0]);
  double squares = 0.0, last = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double part = a[i] - b[i];
    squares += part * part;
    last += part;
  }
  return squares + last * last;
}

/// || M_a - M_b ||
inline double difference(const Composition& a, const Composition& b) {
  return a.size() == 1 ? std::abs(a[0] - b[0]) : std::sqrt(squared_difference(a, b));
}

/// The change along a short way, to first order.
Composition change_along(const CompositionGradient& gradient, const Vec3& way);

/// The gradient, 1/mm, of the composition's part in the direction from composition `from` to `to`.
Vec3 gradient_towards(const CompositionGradient& gradient, const Composition& from, const Composition& to);

/// The way on which the composition changes fastest, as long as the rate at which it does, 1/mm. Of two
/// constituents the gradient itself; of more the sign is arbitrary.
Vec3 steepest(const CompositionGradient& gradient);

/// Material composition variation delta(T) over the vertices (paper, equation 2.2).
inline double composition_variation(const Composition& a, const Composition& b, const Composition& c,
                                    const Composition& d) {
  if (a.size() == 1)
    return std::max(std::max(a[0], b[0]), std::max(c[0], d[0])) -
           std::min(std::min(a[0], b[0]), std::min(c[0], d[0]));
  return std::sqrt(std::max({squared_difference(a, b), squared_difference(a, c), squared_difference(a, d),
                             squared_difference(b, c), squared_difference(b, d), squared_difference(c, d)}));
}

}  // namespace fgmesh
