// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "material/formula_operation.hpp"

namespace fgmesh {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Negate : OperationTraits {
  static double value(double a) { return -a; }
  static Slopes<1> slopes(double, double) { return {-1.0}; }
  static Interval bounds(const Interval& a) { return -a; }
  static SlopeBounds<1> slope_bounds(const Interval&, const Interval&) { return {Interval::point(-1.0)}; }
};

struct Add : OperationTraits {
  static double value(double a, double b) { return a + b; }
  static Slopes<2> slopes(double, double, double) { return {1.0, 1.0}; }
  static Interval bounds(const Interval& a, const Interval& b) { return a + b; }
  static SlopeBounds<2> slope_bounds(const Interval&, const Interval&, const Interval&) {
    return {Interval::point(1.0), Interval::point(1.0)};
  }
};

struct Subtract : OperationTraits {
  static double value(double a, double b) { return a - b; }
  static Slopes<2> slopes(double, double, double) { return {1.0, -1.0}; }
  static Interval bounds(const Interval& a, const Interval& b) { return a - b; }
  static SlopeBounds<2> slope_bounds(const Interval&, const Interval&, const Interval&) {
    return {Interval::point(1.0), Interval::point(-1.0)};
  }
};

struct Multiply : OperationTraits {
  static double value(double a, double b) { return a * b; }
  static Slopes<2> slopes(double a, double b, double) { return {b, a}; }
  // Equal addresses: the very same value twice, never negative.
  static Interval bounds(const Interval& a, const Interval& b) { return &a == &b ? square(a) : a * b; }
  static SlopeBounds<2> slope_bounds(const Interval& a, const Interval& b, const Interval&) { return {b, a}; }
};

struct Divide : OperationTraits {
  // Zero has no sign: the same quotient on either side of it, whichever way the divisor came to be zero.
  static double value(double a, double b) { return a / (b + 0.0); }
  static Slopes<2> slopes(double, double b, double value) { return {1.0 / b, -value / b}; }
  static Interval bounds(const Interval& a, const Interval& b) { return a / b; }
  static SlopeBounds<2> slope_bounds(const Interval&, const Interval& b, const Interval& value) {
    return {Interval::point(1.0) / b, -value / b};
  }
};

struct Square : OperationTraits {
  static double value(double a) { return a * a; }
  static Slopes<1> slopes(double a, double) { return {2.0 * a}; }
  static Interval bounds(const Interval& a) { return square(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) {
    return {Interval::point(2.0) * a};
  }
};

template <class Compare>
struct Comparison : OperationTraits {
  static double value(double a, double b) {
    return std::isunordered(a, b) ? kNaN : static_cast<double>(Compare::holds(a, b));
  }
  static Slopes<2> slopes(double, double, double) { return {0.0, 0.0}; }
  static Interval bounds(const Interval& a, const Interval& b) {
    if (Compare::certain(a, b)) return Interval::point(1.0);
    return Compare::impossible(a, b) ? Interval::point(0.0) : Interval{0.0, 1.0};
  }
  static SlopeBounds<2> slope_bounds(const Interval&, const Interval&, const Interval& value) {
    return {slope_of_steps(value), slope_of_steps(value)};
  }
};

struct Less {
  static bool holds(double a, double b) { return a < b; }
  static bool certain(const Interval& a, const Interval& b) { return a.high < b.low; }
  static bool impossible(const Interval& a, const Interval& b) { return a.low >= b.high; }
};

struct Equal {
  static bool holds(double a, double b) { return a == b; }
  static bool certain(const Interval& a, const Interval& b) {
    return a.is_point() && b.is_point() && a.low == b.low;
  }
  static bool impossible(const Interval& a, const Interval& b) { return a.high < b.low || b.high < a.low; }
};

template <class Compare>
struct Not {
  static bool holds(double a, double b) { return !Compare::holds(a, b); }
  static bool certain(const Interval& a, const Interval& b) { return Compare::impossible(a, b); }
  static bool impossible(const Interval& a, const Interval& b) { return Compare::certain(a, b); }
};

template <class Compare>
struct Swapped {
  static bool holds(double a, double b) { return Compare::holds(b, a); }
  static bool certain(const Interval& a, const Interval& b) { return Compare::certain(b, a); }
  static bool impossible(const Interval& a, const Interval& b) { return Compare::impossible(b, a); }
};

struct Select : OperationTraits {
  static constexpr bool kPartial = true;

  static double value(double condition, double a, double b) {
    if (std::isnan(condition)) return kNaN;
    return condition != 0.0 ? a : b;
  }
  static Slopes<3> slopes(double condition, double, double, double) {
    return condition != 0.0 ? Slopes<3>{0.0, 1.0, 0.0} : Slopes<3>{0.0, 0.0, 1.0};
  }
  static Interval bounds(const Interval& condition, const Interval& a, const Interval& b) {
    if (condition.is_empty()) return Interval::empty();
    if (!condition.contains(0.0)) return a;
    return condition.is_point() ? b : hull(a, b);
  }
  static SlopeBounds<3> slope_bounds(const Interval& condition, const Interval&, const Interval&,
                                     const Interval&) {
    const Interval none = Interval::point(0.0), all = Interval::point(1.0), either{0.0, 1.0};
    if (!condition.contains(0.0)) return {none, all, none};
    if (condition.is_point()) return {none, none, all};
    // The branches need not meet where the condition turns.
    return {Interval::whole(), either, either};
  }
};

}  // namespace

const Operation* find_operator(std::string_view symbol) {
  static const std::vector<Operation> operators = {
      operation<Add>("+"),
      operation<Subtract>("-"),
      operation<Multiply>("*"),
      operation<Divide>("/"),
      operation<Comparison<Less>>("<"),
      operation<Comparison<Not<Swapped<Less>>>>("<="),
      operation<Comparison<Swapped<Less>>>(">"),
      operation<Comparison<Not<Less>>>(">="),
      operation<Comparison<Equal>>("=="),
      operation<Comparison<Not<Equal>>>("!="),
  };
  if (symbol == "^") return find_function("pow");
  const auto found = std::find_if(operators.begin(), operators.end(),
                                  [symbol](const Operation& candidate) { return candidate.name == symbol; });
  return found == operators.end() ? nullptr : &*found;
}

const Operation& negation() {
  static const Operation result = operation<Negate>("-");
  return result;
}

const Operation& squaring() {
  static const Operation result = operation<Square>("^2");
  return result;
}

const Operation& selection() {
  static const Operation result = operation<Select>("if");
  return result;
}

}  // namespace fgmesh
