// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/formula_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fgmesh {
namespace {

constexpr std::size_t kDualRows = 4;
// 64 KB: little enough for any thread's stack, enough for one dual block of the largest program.
constexpr std::size_t kWorkspaceSize = 8192;
constexpr std::size_t kLargestBlock = 128;
static_assert(FormulaProgram::kMaxRegisters * kDualRows <= kWorkspaceSize);

std::size_t block_size(std::size_t registers, std::size_t rows, std::size_t count) {
  return std::min({count, kLargestBlock, kWorkspaceSize / (registers * rows)});
}

/// Calls `body(first, count)` for block after block.
template <class Body>
void for_each_block(std::size_t count, std::size_t block, Body body) {
  for (std::size_t first = 0; first < count; first += block) body(first, std::min(block, count - first));
}

}  // namespace

void FormulaProgram::run_values(double* workspace, std::size_t stride, std::size_t count) const noexcept {
  for (const Instruction& instruction : instructions_) {
    double* const out = workspace + instruction.out * stride;
    if (!instruction.operation) {
      std::fill_n(out, count, instruction.constant.value);
      continue;
    }
    const double* const in[] = {workspace + instruction.in[0] * stride,
                                workspace + instruction.in[1] * stride,
                                workspace + instruction.in[2] * stride};
    instruction.operation->values(in, out, count);
  }
}

void FormulaProgram::run_duals(double* workspace, std::size_t stride, std::size_t count) const noexcept {
  const std::size_t size = kDualRows * stride;
  for (const Instruction& instruction : instructions_) {
    double* const out = workspace + instruction.out * size;
    if (!instruction.operation) {
      std::fill_n(out, count, instruction.constant.value);
      for (std::size_t row = 1; row < kDualRows; ++row) std::fill_n(out + row * stride, count, 0.0);
      continue;
    }
    const double* const in[] = {workspace + instruction.in[0] * size, workspace + instruction.in[1] * size,
                                workspace + instruction.in[2] * size};
    instruction.operation->duals(in, out, stride, count);
  }
}

void FormulaProgram::evaluate(const PointInputs& inputs, std::size_t count, double* values) const noexcept {
  alignas(64) double workspace[kWorkspaceSize];
  const std::size_t stride = block_size(register_count_, 1, count);
  for_each_block(count, stride, [&](std::size_t first, std::size_t size) {
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      inputs.values(variables_[v], first, size, workspace + variable_registers_[v] * stride);
    }
    run_values(workspace, stride, size);
    std::copy_n(workspace + result_ * stride, size, values + first);
  });
}

void FormulaProgram::evaluate(const PointInputs& inputs, std::size_t count, double* values,
                              Vec3* gradients) const noexcept {
  alignas(64) double workspace[kWorkspaceSize];
  const std::size_t stride = block_size(register_count_, kDualRows, count);
  for_each_block(count, stride, [&](std::size_t first, std::size_t size) {
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      inputs.duals(variables_[v], first, size, stride,
                   workspace + variable_registers_[v] * kDualRows * stride);
    }
    run_duals(workspace, stride, size);
    const double* const result = workspace + result_ * kDualRows * stride;
    std::copy_n(result, size, values + first);
    for (std::size_t i = 0; i < size; ++i) {
      gradients[first + i] = Vec3(result[stride + i], result[2 * stride + i], result[3 * stride + i]);
      if (std::isnan(result[i])) gradients[first + i].setConstant(result[i]);
    }
  });
}

Interval FormulaProgram::bounds(const std::vector<Interval>& box) const noexcept {
  Interval registers[kMaxRegisters];
  for (std::size_t v = 0; v < variables_.size(); ++v) registers[variable_registers_[v]] = box[v];
  for (const Instruction& instruction : instructions_) {
    const Interval* const in[] = {registers + instruction.in[0], registers + instruction.in[1],
                                  registers + instruction.in[2]};
    registers[instruction.out] =
        instruction.operation ? instruction.operation->bounds(in) : instruction.constant.bounds;
  }
  return registers[result_];
}

DualInterval FormulaProgram::dual_bounds(const DualInterval* box) const noexcept {
  // Most programs need a few registers, and to clear all that a program may have would take longer than to
  // run it.
  constexpr std::size_t kFew = 32;
  std::array<DualInterval, kFew> few;
  std::vector<DualInterval> many;
  if (register_count_ > kFew) many.resize(register_count_);
  DualInterval* const registers = register_count_ > kFew ? many.data() : few.data();
  for (std::size_t v = 0; v < variables_.size(); ++v) registers[variable_registers_[v]] = box[v];
  for (const Instruction& instruction : instructions_) {
    const DualInterval* const in[] = {registers + instruction.in[0], registers + instruction.in[1],
                                      registers + instruction.in[2]};
    DualInterval& out = registers[instruction.out];
    if (instruction.operation)
      out = instruction.operation->dual_bounds(in);
    else
      out = {instruction.constant.bounds};
  }
  return registers[result_];
}

std::uint16_t ProgramBuilder::allocate() {
  if (free_.empty()) return static_cast<std::uint16_t>(program_.register_count_++);
  const std::uint16_t place = free_.back();
  free_.pop_back();
  return place;
}

void ProgramBuilder::release(const Operand& operand) {
  if (operand.is_temporary) free_.push_back(operand.place);
}

ProgramBuilder::Operand ProgramBuilder::variable(Variable variable) {
  std::vector<Variable>& variables = program_.variables_;
  const auto found = std::find(variables.begin(), variables.end(), variable);
  const std::size_t v = static_cast<std::size_t>(found - variables.begin());
  if (found == variables.end()) {
    variables.push_back(variable);
    // A register of its own: the block's loop fills it once, so no intermediate result may use it.
    program_.variable_registers_.push_back(static_cast<std::uint16_t>(program_.register_count_++));
  }
  return {false, false, program_.variable_registers_[v], {}};
}

ProgramBuilder::Operand ProgramBuilder::loaded(const Operand& operand) {
  if (!operand.is_constant) return operand;
  const std::uint16_t place = allocate();
  program_.instructions_.push_back({nullptr, {}, place, operand.constant});
  return {false, true, place, {}};
}

ProgramBuilder::Operand ProgramBuilder::folded(const Operation& operation,
                                               const std::vector<Operand>& operands) const {
  const double* values[3] = {};
  const Interval* bounds[3] = {};
  for (std::size_t i = 0; i < operands.size(); ++i) {
    values[i] = &operands[i].constant.value;
    bounds[i] = &operands[i].constant.bounds;
  }
  Constant result{};
  operation.values(values, &result.value, 1);
  result.bounds = operation.bounds(bounds);
  return constant(result);
}

ProgramBuilder::Operand ProgramBuilder::apply(const Operation& operation,
                                              const std::vector<Operand>& operands) {
  if (std::all_of(operands.begin(), operands.end(), [](const Operand& o) { return o.is_constant; })) {
    return folded(operation, operands);
  }
  // By far the most frequent power; a product is ten times faster than std::pow and has tighter bounds.
  if (operation.name == "pow" && operands[1].is_constant && operands[1].constant.value == 2.0) {
    return apply(squaring(), {operands[0]});
  }
  FormulaProgram::Instruction instruction;
  instruction.operation = &operation;
  std::vector<Operand> inputs;
  for (const Operand& operand : operands) inputs.push_back(loaded(operand));
  for (std::size_t i = 0; i < inputs.size(); ++i) instruction.in[i] = inputs[i].place;
  // Before the release: kernels need an output apart from their inputs.
  instruction.out = allocate();
  for (const Operand& input : inputs) release(input);
  program_.instructions_.push_back(instruction);
  return {false, true, instruction.out, {}};
}

FormulaProgram ProgramBuilder::finish(const Operand& result) {
  program_.result_ = loaded(result).place;
  return std::move(program_);
}

}  // namespace fgmesh
