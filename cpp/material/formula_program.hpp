// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec3.hpp"
#include "material/formula_names.hpp"
#include "material/formula_operation.hpp"
#include "material/interval.hpp"

namespace fgmesh {

/// Where a program finds its variables at a list of points.
class PointInputs {
 public:
  virtual ~PointInputs() = default;

  /// out[i] for the points first ... first + count - 1.
  virtual void values(Variable variable, std::size_t first, std::size_t count, double* out) const = 0;

  /// As values(), and the gradient's components at out[stride + i], out[2 stride + i] and out[3 stride + i].
  virtual void duals(Variable variable, std::size_t first, std::size_t count, std::size_t stride,
                     double* out) const = 0;
};

/// A formula made ready: a straight list of operations on registers, each of which holds a block of points.
/// Immutable; evaluation needs no memory but the stack, so any number of threads may share one.
class FormulaProgram {
 public:
  static constexpr std::size_t kMaxRegisters = 1024;

  /// Those that the formula uses, each once.
  const std::vector<Variable>& variables() const { return variables_; }

  void evaluate(const PointInputs& inputs, std::size_t count, double* values) const noexcept;

  /// Where a value is NaN so is its gradient, else no component is.
  void evaluate(const PointInputs& inputs, std::size_t count, double* values, Vec3* gradients) const noexcept;

  /// Holds the value at every point where each of variables() lies in its interval of `box`.
  Interval bounds(const std::vector<Interval>& box) const noexcept;

  /// The same, with bounds of the slopes, from those of the variables.
  DualInterval dual_bounds(const DualInterval* box) const noexcept;

 private:
  friend class ProgramBuilder;

  struct Instruction {
    const Operation* operation = nullptr;  // null: load `constant`
    std::array<std::uint16_t, 3> in{};
    std::uint16_t out = 0;
    Constant constant{};
  };

  FormulaProgram() = default;
  void run_values(double* workspace, std::size_t stride, std::size_t count) const noexcept;
  void run_duals(double* workspace, std::size_t stride, std::size_t count) const noexcept;

  std::vector<Instruction> instructions_;
  std::vector<Variable> variables_;
  std::vector<std::uint16_t> variable_registers_;  // of each of them
  std::size_t register_count_ = 0;
  std::uint16_t result_ = 0;
};

/// Writes a program operand by operand and folds what is constant. Each operand is used once.
class ProgramBuilder {
 public:
  struct Operand {
    bool is_constant = false;
    bool is_temporary = false;
    std::uint16_t place = 0;
    Constant constant{};
  };

  Operand constant(const Constant& constant) const { return {true, false, 0, constant}; }
  Operand variable(Variable variable);
  /// `operands`: as many as the operation takes.
  Operand apply(const Operation& operation, const std::vector<Operand>& operands);

  /// More than FormulaProgram::kMaxRegisters make a program that must not run.
  std::size_t register_count() const { return program_.register_count_; }

  FormulaProgram finish(const Operand& result);

 private:
  std::uint16_t allocate();
  void release(const Operand& operand);
  Operand loaded(const Operand& operand);
  Operand folded(const Operation& operation, const std::vector<Operand>& operands) const;

  FormulaProgram program_;
  std::vector<std::uint16_t> free_;
};

}  // namespace fgmesh
