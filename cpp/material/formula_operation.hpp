// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "material/interval.hpp"

namespace fgmesh {

/// What one node of a formula does, as loops over blocks of points: the interpreter pays its dispatch once a
/// block.
///
/// A dual block is four rows of `stride` numbers: value and the three components of the gradient. Output
/// never overlaps input.
struct Operation {
  std::string_view name;  ///< as a formula writes it
  int arity;
  bool variadic;  ///< a function of two that takes more, from left to right: min(a, b, c)

  void (*values)(const double* const* in, double* out, std::size_t count);
  void (*duals)(const double* const* in, double* out, std::size_t stride, std::size_t count);
  Interval (*bounds)(const Interval* const* in);
  DualInterval (*dual_bounds)(const DualInterval* const* in);
};

/// All functions that a formula may call by name; null where there is none of this name.
const Operation* find_function(std::string_view name);
const std::vector<Operation>& formula_functions();

/// The operation behind a binary operator: + - * / ^ < <= > >= == !=; null where there is none.
const Operation* find_operator(std::string_view symbol);
const Operation& negation();
const Operation& squaring();
/// condition, value where it is not zero, value where it is zero: `?:` and `if`. Only the branch taken
/// matters.
const Operation& selection();

/// Partial derivatives with respect to each argument.
template <std::size_t N>
using Slopes = std::array<double, N>;
/// What they can be within a box; where the argument may cross a jump, everything.
template <std::size_t N>
using SlopeBounds = std::array<Interval, N>;

namespace detail {

/// A term of the chain rule. Zero beats infinity: exp(-sqrt(d)) is flat, not undefined, in whatever does not
/// move, and a branch that is not taken has no say.
inline double chain(double slope, double derivative) {
  return slope == 0.0 || derivative == 0.0 ? 0.0 : slope * derivative;
}

template <class Op, std::size_t... I>
struct Kernels {
  static constexpr std::size_t kArity = sizeof...(I);

  static void values(const double* const* in, double* __restrict out, std::size_t count) {
    const double* const arguments[kArity] = {in[I]...};
    for (std::size_t i = 0; i < count; ++i) out[i] = Op::value(arguments[I][i]...);
  }

  static void duals(const double* const* in, double* __restrict out, std::size_t stride, std::size_t count) {
    const double* const arguments[kArity] = {in[I]...};
    for (std::size_t i = 0; i < count; ++i) {
      const double value = Op::value(arguments[I][i]...);
      const Slopes<kArity> slopes = Op::slopes(arguments[I][i]..., value);
      for (std::size_t row = stride; row <= 3 * stride; row += stride) {
        const double sum = (chain(slopes[I], arguments[I][row + i]) + ...);
        out[row + i] = sum == sum ? sum : 0.0;
      }
      out[i] = value;
    }
  }

  static Interval bounds(const Interval* const* in) {
    if constexpr (!Op::kPartial) {
      if ((in[I]->is_empty() || ...)) return Interval::empty();
    }
    return Op::bounds(*in[I]...);
  }

  static DualInterval dual_bounds(const DualInterval* const* in) {
    const Interval* const values[kArity] = {&in[I]->value...};
    DualInterval result;
    result.value = bounds(values);
    // What is defined nowhere has no slope.
    if (result.value.is_empty()) return result;
    const SlopeBounds<kArity> slopes = Op::slope_bounds(in[I]->value..., result.value);
    for (int axis = 0; axis < 3; ++axis) {
      const auto add = [&](const Interval& slope, const DualInterval& argument) {
        const Interval& inner = argument.slope[axis];
        if (inner.is_zero() || argument.value.is_empty()) return;
        // A pole: on its other side the function may go on from the other infinity.
        const Interval term = result.value.is_bounded() ? slope * inner : Interval::whole();
        result.slope[axis] = result.slope[axis].is_zero() ? term : result.slope[axis] + term;
      };
      (add(slopes[I], *in[I]), ...);
    }
    return result;
  }
};

template <class Op, std::size_t... I>
constexpr Operation make_operation(std::string_view name, bool variadic, std::index_sequence<I...>) {
  using K = Kernels<Op, I...>;
  return {name, static_cast<int>(sizeof...(I)), variadic, K::values, K::duals, K::bounds, K::dual_bounds};
}

template <class... Doubles>
constexpr std::size_t arity_of(double (*)(Doubles...)) {
  return sizeof...(Doubles);
}

}  // namespace detail

/// Base of the structs that describe an operation: static `value(a, ...)`, `slopes(a, ..., value)`,
/// `bounds(a, ...)` and `slope_bounds(a, ..., value)`. Derived structs with kPartial see empty intervals too.
struct OperationTraits {
  static constexpr bool kPartial = false;
};

/// Slope of a function that is constant but for its jumps, where its values are these.
inline Interval slope_of_steps(const Interval& value) {
  return value.is_point() ? Interval::point(0.0) : Interval::whole();
}

template <class Op>
constexpr Operation operation(std::string_view name, bool variadic = false) {
  return detail::make_operation<Op>(name, variadic, std::make_index_sequence<detail::arity_of(&Op::value)>());
}

}  // namespace fgmesh
