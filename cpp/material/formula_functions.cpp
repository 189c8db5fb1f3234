// SPDX-License-Identifier: GPL-3.0-or-later
//
// The functions of a formula. A new one is a struct (value, partial derivatives, bounds) and a row in the
// table at the end. Values follow IEEE 754 with two restrictions: NaN in, NaN out, always; and zero has no
// sign (`+ 0.0` turns -0 into +0 where it would matter), or bounds could not be certain at the border of a
// box. Where a derivative is not unique it is the mean of those of the sides, or zero.
#include <algorithm>
#include <cmath>
#include <limits>

#include "material/formula_operation.hpp"

namespace fgmesh {
namespace {

constexpr double kLn10 = 2.302585092994045684;
const Interval kLn10Bounds = widened(kLn10, kLn10);
const Interval kOne = Interval::point(1.0);
const Interval kNotNegative{0.0, std::numeric_limits<double>::infinity()};

struct Exp : OperationTraits {
  static double value(double a) { return std::exp(a); }
  static Slopes<1> slopes(double, double value) { return {value}; }
  static Interval bounds(const Interval& a) { return exp(a); }
  static SlopeBounds<1> slope_bounds(const Interval&, const Interval& value) { return {value}; }
};

struct Log : OperationTraits {
  static double value(double a) { return std::log(a); }
  static Slopes<1> slopes(double a, double) { return {1.0 / a}; }
  static Interval bounds(const Interval& a) { return log(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) {
    return {kOne / intersection(a, kNotNegative)};
  }
};

struct Log10 : OperationTraits {
  static double value(double a) { return std::log10(a); }
  static Slopes<1> slopes(double a, double) { return {1.0 / (a * kLn10)}; }
  static Interval bounds(const Interval& a) { return log10(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) {
    return {kOne / (intersection(a, kNotNegative) * kLn10Bounds)};
  }
};

struct Sqrt : OperationTraits {
  static double value(double a) { return std::sqrt(a); }
  // The root of -0 is -0, which must not turn the slope round.
  static Slopes<1> slopes(double, double value) { return {0.5 / std::fabs(value)}; }
  static Interval bounds(const Interval& a) { return sqrt(a); }
  static SlopeBounds<1> slope_bounds(const Interval&, const Interval& value) {
    return {Interval::point(0.5) / value};
  }
};

struct Cbrt : OperationTraits {
  static double value(double a) { return std::cbrt(a); }
  static Slopes<1> slopes(double, double value) { return {1.0 / (3.0 * value * value)}; }
  static Interval bounds(const Interval& a) { return cbrt(a); }
  static SlopeBounds<1> slope_bounds(const Interval&, const Interval& value) {
    return {kOne / (Interval::point(3.0) * square(value))};
  }
};

struct Pow : OperationTraits {
  // IEEE 754 lets pow(NaN, 0) and pow(1, NaN) be 1 and pow(-inf, 0.5) be inf: what is undefined would vanish
  // without a trace.
  static double value(double a, double b) {
    if (std::isunordered(a, b)) return a + b;
    return a < 0.0 && b != std::floor(b) ? std::numeric_limits<double>::quiet_NaN() : std::pow(a + 0.0, b);
  }
  static Slopes<2> slopes(double a, double b, double value) {
    const double by_base = a != 0.0 ? b * (value / a) : b == 0.0 ? 0.0 : b * std::pow(a, b - 1.0);
    return {by_base, a > 0.0 ? value * std::log(a) : 0.0};
  }
  static Interval bounds(const Interval& a, const Interval& b) { return pow(a, b); }
  static SlopeBounds<2> slope_bounds(const Interval& a, const Interval& b, const Interval& value) {
    const bool whole_power = b.is_point() && std::floor(b.low) == b.low;
    // Undefined places between those where it is defined: it may be anything beyond them.
    if (a.low < 0.0 && !whole_power) return {Interval::whole(), Interval::whole()};
    return {b * pow(a, b - kOne), a.low < 0.0 ? Interval::whole() : value * log(a)};
  }
};

struct Abs : OperationTraits {
  static double value(double a) { return std::fabs(a); }
  static Slopes<1> slopes(double a, double) { return {a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0}; }
  static Interval bounds(const Interval& a) { return abs(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) {
    return {a.low >= 0.0 ? kOne : a.high <= 0.0 ? -kOne : Interval{-1.0, 1.0}};
  }
};

/// A function that is constant but for its jumps.
struct Jumps : OperationTraits {
  static Slopes<1> slopes(double, double) { return {0.0}; }
  static SlopeBounds<1> slope_bounds(const Interval&, const Interval& value) {
    return {slope_of_steps(value)};
  }
};

struct Sign : Jumps {
  static double value(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : a == 0.0 ? 0.0 : a; }
  static Interval bounds(const Interval& a) { return {value(a.low), value(a.high)}; }
};

struct Floor : Jumps {
  static double value(double a) { return std::floor(a); }
  static Interval bounds(const Interval& a) { return floor(a); }
};

struct Ceil : Jumps {
  static double value(double a) { return std::ceil(a); }
  static Interval bounds(const Interval& a) { return ceil(a); }
};

struct Min : OperationTraits {
  static double value(double a, double b) { return std::isunordered(a, b) ? a + b : a < b ? a : b; }
  static Slopes<2> slopes(double a, double b, double) {
    return a == b ? Slopes<2>{0.5, 0.5} : a < b ? Slopes<2>{1.0, 0.0} : Slopes<2>{0.0, 1.0};
  }
  static Interval bounds(const Interval& a, const Interval& b) { return min(a, b); }
  static SlopeBounds<2> slope_bounds(const Interval& a, const Interval& b, const Interval&) {
    if (a.high <= b.low) return {kOne, Interval::point(0.0)};
    if (b.high <= a.low) return {Interval::point(0.0), kOne};
    return {Interval{0.0, 1.0}, Interval{0.0, 1.0}};
  }
};

struct Max : OperationTraits {
  static double value(double a, double b) { return std::isunordered(a, b) ? a + b : a > b ? a : b; }
  static Slopes<2> slopes(double a, double b, double value) { return Min::slopes(b, a, value); }
  static Interval bounds(const Interval& a, const Interval& b) { return max(a, b); }
  static SlopeBounds<2> slope_bounds(const Interval& a, const Interval& b, const Interval& value) {
    return Min::slope_bounds(b, a, value);
  }
};

struct Sin : OperationTraits {
  static double value(double a) { return std::sin(a); }
  static Slopes<1> slopes(double a, double) { return {std::cos(a)}; }
  static Interval bounds(const Interval& a) { return sin(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {cos(a)}; }
};

struct Cos : OperationTraits {
  static double value(double a) { return std::cos(a); }
  static Slopes<1> slopes(double a, double) { return {-std::sin(a)}; }
  static Interval bounds(const Interval& a) { return cos(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {-sin(a)}; }
};

struct Tan : OperationTraits {
  static double value(double a) { return std::tan(a); }
  static Slopes<1> slopes(double, double value) { return {1.0 + value * value}; }
  static Interval bounds(const Interval& a) { return tan(a); }
  static SlopeBounds<1> slope_bounds(const Interval&, const Interval& value) {
    return {kOne + square(value)};
  }
};

struct Asin : OperationTraits {
  static double value(double a) { return std::asin(a); }
  static Slopes<1> slopes(double a, double) { return {1.0 / std::sqrt((1.0 - a) * (1.0 + a))}; }
  static Interval slope(const Interval& a) {
    return kOne / sqrt(intersection(kOne - square(intersection(a, {-1.0, 1.0})), kNotNegative));
  }
  static Interval bounds(const Interval& a) { return asin(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {slope(a)}; }
};

struct Acos : OperationTraits {
  static double value(double a) { return std::acos(a); }
  static Slopes<1> slopes(double a, double value) { return {-Asin::slopes(a, value)[0]}; }
  static Interval bounds(const Interval& a) { return acos(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {-Asin::slope(a)}; }
};

struct Atan : OperationTraits {
  static double value(double a) { return std::atan(a); }
  static Slopes<1> slopes(double a, double) { return {1.0 / (1.0 + a * a)}; }
  static Interval bounds(const Interval& a) { return atan(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) {
    return {kOne / (kOne + square(a))};
  }
};

struct Atan2 : OperationTraits {
  // The cut belongs to its upper side: the angle lies in (-pi, pi].
  static double value(double y, double x) { return std::atan2(y + 0.0, x + 0.0); }
  static Slopes<2> slopes(double y, double x, double) {
    const double radius = std::hypot(x, y);
    if (radius == 0.0) return {0.0, 0.0};
    return {x / radius / radius, -y / radius / radius};
  }
  static Interval bounds(const Interval& y, const Interval& x) { return atan2(y, x); }
  static SlopeBounds<2> slope_bounds(const Interval& y, const Interval& x, const Interval&) {
    const bool across_cut = x.low < 0.0 && y.low < 0.0 && y.high >= 0.0;
    if (across_cut || (x.contains(0.0) && y.contains(0.0))) return {Interval::whole(), Interval::whole()};
    const Interval squared = square(x) + square(y);
    return {x / squared, -y / squared};
  }
};

struct Sinh : OperationTraits {
  static double value(double a) { return std::sinh(a); }
  static Slopes<1> slopes(double a, double) { return {std::cosh(a)}; }
  static Interval bounds(const Interval& a) { return sinh(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {cosh(a)}; }
};

struct Cosh : OperationTraits {
  static double value(double a) { return std::cosh(a); }
  static Slopes<1> slopes(double a, double) { return {std::sinh(a)}; }
  static Interval bounds(const Interval& a) { return cosh(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {sinh(a)}; }
};

struct Tanh : OperationTraits {
  static double value(double a) { return std::tanh(a); }
  static Slopes<1> slopes(double a, double) {
    const double c = std::cosh(a);
    return {1.0 / c / c};
  }
  static Interval bounds(const Interval& a) { return tanh(a); }
  static SlopeBounds<1> slope_bounds(const Interval& a, const Interval&) { return {kOne / square(cosh(a))}; }
};

/// min(max(v, low), high), also where low > high. The ends belong to the slope inside.
struct Clamp : OperationTraits {
  static double value(double v, double low, double high) { return Min::value(Max::value(v, low), high); }
  static Slopes<3> slopes(double v, double low, double high, double) {
    if (std::max(v, low) > high) return {0.0, 0.0, 1.0};
    return v < low ? Slopes<3>{0.0, 1.0, 0.0} : Slopes<3>{1.0, 0.0, 0.0};
  }
  static Interval bounds(const Interval& v, const Interval& low, const Interval& high) {
    return min(max(v, low), high);
  }
  static SlopeBounds<3> slope_bounds(const Interval& v, const Interval& low, const Interval& high,
                                     const Interval& value) {
    const Interval raised = max(v, low);
    const SlopeBounds<2> to_low = Max::slope_bounds(v, low, raised);
    const SlopeBounds<2> to_high = Min::slope_bounds(raised, high, value);
    return {to_high[0] * to_low[0], to_high[0] * to_low[1], to_high[1]};
  }
};

struct Mix : OperationTraits {
  static double value(double a, double b, double t) { return a + t * (b - a); }
  static Slopes<3> slopes(double a, double b, double t, double) { return {1.0 - t, t, b - a}; }
  static Interval bounds(const Interval& a, const Interval& b, const Interval& t) { return a + t * (b - a); }
  static SlopeBounds<3> slope_bounds(const Interval& a, const Interval& b, const Interval& t,
                                     const Interval&) {
    return {kOne - t, t, b - a};
  }
};

struct Step : OperationTraits {
  static double value(double edge, double v) {
    return std::isunordered(edge, v) ? edge + v : v < edge ? 0.0 : 1.0;
  }
  static Slopes<2> slopes(double, double, double) { return {0.0, 0.0}; }
  static Interval bounds(const Interval& edge, const Interval& v) {
    return {v.low >= edge.high ? 1.0 : 0.0, v.high < edge.low ? 0.0 : 1.0};
  }
  static SlopeBounds<2> slope_bounds(const Interval&, const Interval&, const Interval& value) {
    return {slope_of_steps(value), slope_of_steps(value)};
  }
};

/// 3 t^2 - 2 t^3 of t = (v - low) / (high - low) clamped to [0, 1]; step(low, v) where low = high.
struct Smoothstep : OperationTraits {
  static double value(double low, double high, double v) {
    if (low == high) return Step::value(low, v);
    const double t = Clamp::value((v - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
  }
  static Slopes<3> slopes(double low, double high, double v, double) {
    const double t = (v - low) / (high - low);
    if (low == high || !(t > 0.0 && t < 1.0)) return {0.0, 0.0, 0.0};
    const double slope = 6.0 * t * (1.0 - t) / (high - low);
    return {slope * (t - 1.0), -slope * t, slope};
  }
  static Interval bounds(const Interval& low, const Interval& high, const Interval& v) {
    if (low.is_point() && high.is_point() && low.low == high.low) return Step::bounds(low, v);
    const Interval width = high - low;
    if (width.contains(0.0)) return {0.0, 1.0};
    const Interval t = min(max((v - low) / width, Interval::point(0.0)), Interval::point(1.0));
    const auto rise = [](double s) { return s * s * (3.0 - 2.0 * s); };
    return intersection(widened(rise(t.low), rise(t.high)), {0.0, 1.0});
  }
  static SlopeBounds<3> slope_bounds(const Interval& low, const Interval& high, const Interval& v,
                                     const Interval& value) {
    const Interval width = high - low;
    if (width.contains(0.0)) {
      const Interval slope = slope_of_steps(value);
      return {slope, slope, slope};
    }
    const Interval t = min(max((v - low) / width, Interval::point(0.0)), kOne);
    // 6 t (1 - t) is largest in the middle.
    const auto rate = [](double s) { return 6.0 * s * (1.0 - s); };
    Interval rates = widened(std::min(rate(t.low), rate(t.high)), std::max(rate(t.low), rate(t.high)));
    if (t.contains(0.5)) rates.high = 1.5;
    const Interval slope = intersection(rates, {0.0, 1.5}) / width;
    return {slope * (t - kOne), -slope * t, slope};
  }
};

}  // namespace

const std::vector<Operation>& formula_functions() {
  static const std::vector<Operation> table = {
      operation<Exp>("exp"),
      operation<Log>("log"),
      operation<Log10>("log10"),
      operation<Sqrt>("sqrt"),
      operation<Cbrt>("cbrt"),
      operation<Pow>("pow"),
      operation<Abs>("abs"),
      operation<Sign>("sign"),
      operation<Min>("min", true),
      operation<Max>("max", true),
      operation<Sin>("sin"),
      operation<Cos>("cos"),
      operation<Tan>("tan"),
      operation<Asin>("asin"),
      operation<Acos>("acos"),
      operation<Atan>("atan"),
      operation<Atan2>("atan2"),
      operation<Sinh>("sinh"),
      operation<Cosh>("cosh"),
      operation<Tanh>("tanh"),
      operation<Floor>("floor"),
      operation<Ceil>("ceil"),
      operation<Clamp>("clamp"),
      operation<Mix>("mix"),
      operation<Step>("step"),
      operation<Smoothstep>("smoothstep"),
      selection(),
  };
  return table;
}

const Operation* find_function(std::string_view name) {
  const auto& table = formula_functions();
  const auto found = std::find_if(table.begin(), table.end(),
                                  [name](const Operation& candidate) { return candidate.name == name; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace fgmesh
