// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>

namespace fgmesh {

/// A closed interval of extended reals that certainly contains every value it stands for: each operation
/// rounds outward. Low above high (or NaN) means empty: the expression is defined nowhere in the box.
///
/// Functions restrict their argument to their domain, log([-1, 1]) = [-inf, 0], so that an undefined part
/// of a box widens nothing.
struct Interval {
  double low;
  double high;

  static Interval point(double value) { return {value, value}; }
  static Interval whole() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  static Interval empty() {
    return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  }

  bool is_empty() const { return !(low <= high); }
  bool is_point() const { return low == high; }
  bool is_zero() const { return low == 0.0 && high == 0.0; }
  bool is_bounded() const {
    return low > -std::numeric_limits<double>::infinity() && high < std::numeric_limits<double>::infinity();
  }
  bool contains(double value) const { return low <= value && value <= high; }
};

/// Bounds of a function over a box, and of its slopes along the axes, 1/mm: between any two points of the box
/// the function changes by a vector of them times the way. Everything where it may jump.
struct DualInterval {
  Interval value{0.0, 0.0};
  std::array<Interval, 3> slope{Interval{0.0, 0.0}, Interval{0.0, 0.0}, Interval{0.0, 0.0}};
};

Interval hull(const Interval& a, const Interval& b);
Interval intersection(const Interval& a, const Interval& b);

// The arguments of everything below must not be empty.

Interval operator-(const Interval& a);
Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
/// Zero has no sign here, and a number above zero divided by it is +inf, as evaluation has it. So a divisor
/// that holds zero gives everything, but for one that starts there: [1, 2] / [0, 4] = [0.25, inf].
Interval operator/(const Interval& a, const Interval& b);

Interval square(const Interval& a);
Interval abs(const Interval& a);
Interval min(const Interval& a, const Interval& b);
Interval max(const Interval& a, const Interval& b);
Interval floor(const Interval& a);
Interval ceil(const Interval& a);
Interval sqrt(const Interval& a);
Interval cbrt(const Interval& a);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval log10(const Interval& a);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
/// In (-pi, pi], a zero `y` counting as positive; all of it where the box touches the cut (x < 0, y = 0) from
/// below.
Interval atan2(const Interval& y, const Interval& x);
/// Bases below zero count where the exponent can be an integer.
Interval pow(const Interval& base, const Interval& exponent);

/// [low, high] widened by a few units in the last place: more than the C library's functions err by.
Interval widened(double low, double high);

}  // namespace fgmesh
