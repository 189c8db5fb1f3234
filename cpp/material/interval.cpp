// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/interval.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace fgmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kPi = 3.14159265358979323846;
// Below this the error terms of products and quotients may be subnormal and vanish.
constexpr double kErrorTermsVanish = 1e-290;

/// std::nextafter(value, -inf), which is a call that takes longer than the operation it corrects.
double next_down(double value) {
  if (!(value > -kInfinity)) return value;  // NaN, too
  if (value == 0.0) return -std::numeric_limits<double>::denorm_min();
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits += value > 0.0 ? -1 : 1;
  std::memcpy(&value, &bits, sizeof bits);
  return value;
}

// Directed rounding without touching the processor's rounding mode: the error of the rounded result is
// computed exactly (Knuth's two-sum; a fused multiply-add), so results that are exact stay exact.

double add_down(double a, double b) {
  const double sum = a + b;
  if (std::isnan(sum)) return -kInfinity;
  if (std::isinf(sum)) return sum < 0.0 ? sum : next_down(sum);
  const double part = sum - a;
  const double error = (a - (sum - part)) + (b - part);
  return error >= 0.0 ? sum : next_down(sum);
}

double multiply_down(double a, double b) {
  if (a == 0.0 || b == 0.0) return 0.0;
  const double product = a * b;
  if (std::isinf(product)) return product < 0.0 ? product : next_down(product);
  if (std::fabs(product) < kErrorTermsVanish) return next_down(product);
  return std::fma(a, b, -product) >= 0.0 ? product : next_down(product);
}

double divide_down(double a, double b) {
  if (a == 0.0) return 0.0;
  const double quotient = a / b;
  if (std::isnan(quotient)) return std::signbit(a) == std::signbit(b) ? 0.0 : -kInfinity;
  if (std::isinf(quotient)) return quotient < 0.0 ? quotient : next_down(quotient);
  if (std::isinf(b)) return quotient;
  if (std::fabs(quotient) < kErrorTermsVanish || std::fabs(a) < kErrorTermsVanish) return next_down(quotient);
  const double remainder = std::fma(-quotient, b, a);
  return remainder == 0.0 || (remainder < 0.0) == (b < 0.0) ? quotient : next_down(quotient);
}

/// The square of the rounded root less `value`: its sign tells how the root was rounded.
double root_error(double root, double value) {
  return value < kErrorTermsVanish ? std::numeric_limits<double>::quiet_NaN() : std::fma(root, root, -value);
}

double root_down(double value) {
  const double root = std::sqrt(value);
  return value == 0.0 || root_error(root, value) <= 0.0 ? root : next_down(root);
}

double root_up(double value) {
  const double root = std::sqrt(value);
  return value == 0.0 || root_error(root, value) >= 0.0 ? root : std::nextafter(root, kInfinity);
}

double add_up(double a, double b) { return -add_down(-a, -b); }
double multiply_up(double a, double b) { return -multiply_down(-a, b); }
double divide_up(double a, double b) { return -divide_down(-a, b); }

template <class Function>
Interval increasing(Function f, const Interval& a, const Interval& range = Interval::whole()) {
  return intersection(widened(f(a.low), f(a.high)), range);
}

template <class Function>
Interval decreasing(Function f, const Interval& a, const Interval& range = Interval::whole()) {
  return intersection(widened(f(a.high), f(a.low)), range);
}

/// True where offset + k period may lie in `a` for a whole k. Says yes in doubt.
bool may_hold_multiple(const Interval& a, double offset, double period) {
  const double scale = std::max(std::fabs(a.low), std::fabs(a.high));
  if (!(scale < 1e12)) return true;
  const double slack = 16.0 * kEpsilon * (1.0 + scale);
  return std::ceil((a.low - offset) / period - slack) <= (a.high - offset) / period + slack;
}

/// A wave of period 2 pi between -1 and 1 with crests at `crest`.
template <class Function>
Interval wave(Function f, const Interval& a, double crest) {
  if (!std::isfinite(a.low) || !std::isfinite(a.high)) return {-1.0, 1.0};
  const double first = f(a.low), last = f(a.high);
  Interval result = intersection(widened(std::min(first, last), std::max(first, last)), {-1.0, 1.0});
  if (may_hold_multiple(a, crest, 2.0 * kPi)) result.high = 1.0;
  if (may_hold_multiple(a, crest + kPi, 2.0 * kPi)) result.low = -1.0;
  return result;
}

Interval pow_integer(const Interval& base, double n) {
  const auto power = [n](double value) { return std::pow(value, n); };
  if (n == 0.0) return Interval::point(1.0);
  if (std::fmod(n, 2.0) == 0.0) {
    const Interval magnitude = abs(base);
    return n > 0.0 ? increasing(power, magnitude, {0.0, kInfinity})
                   : decreasing(power, magnitude, {0.0, kInfinity});
  }
  if (n > 0.0) return increasing(power, base);
  if (base.low > 0.0 || base.high < 0.0) return decreasing(power, base);
  if (base.low < 0.0 || base.high == 0.0) return Interval::whole();
  return {widened(power(base.high), kInfinity).low, kInfinity};
}

/// base >= 0. The power is exp(exponent log(base)), bilinear in exponent and logarithm: corners bound it.
Interval pow_of_positive(const Interval& base, const Interval& exponent) {
  const double bottom = base.low + 0.0, top = base.high + 0.0;  // pow(-0, -1) would be -inf
  const double corners[] = {std::pow(bottom, exponent.low), std::pow(bottom, exponent.high),
                            std::pow(top, exponent.low), std::pow(top, exponent.high)};
  const auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners));
  return intersection(widened(*low, *high), {0.0, kInfinity});
}

}  // namespace

Interval widened(double low, double high) {
  constexpr double kTiny = std::numeric_limits<double>::min();
  constexpr double kLargest = std::numeric_limits<double>::max();
  const auto margin = [](double value) { return 8.0 * kEpsilon * std::fabs(value) + kTiny; };
  return {low == kInfinity ? kLargest : low - margin(low),
          high == -kInfinity ? -kLargest : high + margin(high)};
}

Interval hull(const Interval& a, const Interval& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

Interval operator-(const Interval& a) { return {-a.high, -a.low}; }

Interval operator+(const Interval& a, const Interval& b) {
  return {add_down(a.low, b.low), add_up(a.high, b.high)};
}

Interval operator-(const Interval& a, const Interval& b) { return a + (-b); }

Interval operator*(const Interval& a, const Interval& b) {
  // Mostly one of them does not change sign, and its sign tells which ends make the product's.
  if (a.low >= 0.0)
    return {multiply_down(b.low >= 0.0 ? a.low : a.high, b.low),
            multiply_up(b.high >= 0.0 ? a.high : a.low, b.high)};
  if (a.high <= 0.0) return -(-a * b);
  if (b.low >= 0.0 || b.high <= 0.0) return b * a;
  return {std::min(multiply_down(a.low, b.high), multiply_down(a.high, b.low)),
          std::max(multiply_up(a.low, b.low), multiply_up(a.high, b.high))};
}

Interval operator/(const Interval& a, const Interval& b) {
  if (b.low <= 0.0 && b.high >= 0.0) {
    if (b.low < 0.0 || b.high == 0.0) return Interval::whole();
    return {a.low >= 0.0 ? divide_down(a.low, b.high) : -kInfinity,
            a.high <= 0.0 ? divide_up(a.high, b.high) : kInfinity};
  }
  if (b.high < 0.0) return -a / -b;
  return {divide_down(a.low, a.low >= 0.0 ? b.high : b.low),
          divide_up(a.high, a.high >= 0.0 ? b.low : b.high)};
}

Interval square(const Interval& a) {
  const Interval magnitude = abs(a);
  return {multiply_down(magnitude.low, magnitude.low), multiply_up(magnitude.high, magnitude.high)};
}

Interval abs(const Interval& a) {
  if (a.contains(0.0)) return {0.0, std::max(-a.low, a.high)};
  return a.low > 0.0 ? a : -a;
}

Interval min(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::min(a.high, b.high)};
}
Interval max(const Interval& a, const Interval& b) {
  return {std::max(a.low, b.low), std::max(a.high, b.high)};
}
Interval floor(const Interval& a) { return {std::floor(a.low), std::floor(a.high)}; }
Interval ceil(const Interval& a) { return {std::ceil(a.low), std::ceil(a.high)}; }

Interval sqrt(const Interval& a) {
  const Interval domain = intersection(a, {0.0, kInfinity});
  if (domain.is_empty()) return domain;
  return {root_down(domain.low), root_up(domain.high)};
}

Interval cbrt(const Interval& a) {
  return increasing([](double v) { return std::cbrt(v); }, a);
}

Interval exp(const Interval& a) {
  return increasing([](double v) { return std::exp(v); }, a, {0.0, kInfinity});
}

Interval log(const Interval& a) {
  const Interval domain = intersection(a, {0.0, kInfinity});
  return domain.is_empty() ? domain : increasing([](double v) { return std::log(v); }, domain);
}

Interval log10(const Interval& a) {
  const Interval domain = intersection(a, {0.0, kInfinity});
  return domain.is_empty() ? domain : increasing([](double v) { return std::log10(v); }, domain);
}

Interval sin(const Interval& a) {
  return wave([](double v) { return std::sin(v); }, a, kPi / 2.0);
}

Interval cos(const Interval& a) {
  return wave([](double v) { return std::cos(v); }, a, 0.0);
}

Interval tan(const Interval& a) {
  if (may_hold_multiple(a, kPi / 2.0, kPi)) return Interval::whole();
  return increasing([](double v) { return std::tan(v); }, a);
}

Interval asin(const Interval& a) {
  const Interval domain = intersection(a, {-1.0, 1.0});
  return domain.is_empty() ? domain : increasing([](double v) { return std::asin(v); }, domain);
}

Interval acos(const Interval& a) {
  const Interval domain = intersection(a, {-1.0, 1.0});
  return domain.is_empty() ? domain
                           : decreasing([](double v) { return std::acos(v); }, domain, {0.0, kInfinity});
}

Interval atan(const Interval& a) {
  return increasing([](double v) { return std::atan(v); }, a);
}

Interval sinh(const Interval& a) {
  return increasing([](double v) { return std::sinh(v); }, a);
}

Interval cosh(const Interval& a) {
  return increasing([](double v) { return std::cosh(v); }, abs(a), {1.0, kInfinity});
}

Interval tanh(const Interval& a) {
  return increasing([](double v) { return std::tanh(v); }, a, {-1.0, 1.0});
}

Interval atan2(const Interval& y, const Interval& x) {
  if (x.low < 0.0 && y.low < 0.0 && y.high >= 0.0) return widened(-kPi, kPi);
  Interval result = Interval::empty();
  for (const double y_corner : {y.low, y.high}) {
    for (const double x_corner : {x.low, x.high}) {
      // Adding zero turns -0 into +0, as evaluation does.
      result = hull(result, Interval::point(std::atan2(y_corner + 0.0, x_corner + 0.0)));
    }
  }
  return widened(result.low, result.high);
}

Interval pow(const Interval& base, const Interval& exponent) {
  if (exponent.is_point() && std::floor(exponent.low) == exponent.low && std::isfinite(exponent.low)) {
    return pow_integer(base, exponent.low);
  }
  const Interval positive = intersection(base, {0.0, kInfinity});
  Interval result = positive.is_empty() ? positive : pow_of_positive(positive, exponent);
  if (base.low < 0.0 && std::floor(exponent.high) >= exponent.low) {
    const Interval magnitude = pow_of_positive(abs(intersection(base, {-kInfinity, 0.0})), exponent);
    result = hull(result, hull(magnitude, -magnitude));
  }
  return result;
}

}  // namespace fgmesh
