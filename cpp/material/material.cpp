// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material.hpp"

#include <boost/container/small_vector.hpp>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "material/formula_parser.hpp"
#include "material/formula_program.hpp"
#include "material/point_variables.hpp"

namespace fgmesh {
namespace {

void check_frame(const Frame& frame) {
  if (!frame.origin.allFinite() || !frame.rotation.allFinite()) {
    throw InvalidInput("the material's frame holds a number that is not finite");
  }
  // Far above what rounding does to a rotation, far below what a scaling or a shear is meant to do.
  constexpr double kTolerance = 1e-6;
  const Eigen::Matrix3d deviation = frame.rotation.transpose() * frame.rotation - Eigen::Matrix3d::Identity();
  if (deviation.cwiseAbs().maxCoeff() > kTolerance || frame.rotation.determinant() < 0.0) {
    throw InvalidInput(
        "the rotation of the material's frame is none: its columns must be right-handed perpendicular unit "
        "vectors");
  }
}

std::vector<FormulaProgram> programs_of(const std::vector<std::string>& fractions,
                                        const std::map<std::string, double>& parameters,
                                        const std::vector<Reference>& references, std::size_t table_count) {
  if (fractions.empty()) {
    throw InvalidInput("a material needs a formula: the volume fraction of its first constituent");
  }
  std::vector<FormulaProgram> result;
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    try {
      result.push_back(parse_formula(fractions[i], parameters, references, table_count));
    } catch (const FormulaError& error) {
      if (fractions.size() == 1) throw;
      throw FormulaError("formula " + std::to_string(i + 1) + ": " + error.what(), error.position(), i);
    }
  }
  return result;
}

const std::map<std::string, double>& checked(const std::map<std::string, double>& parameters) {
  check_parameters(parameters);
  return parameters;
}

}  // namespace

struct Material::State {
  std::vector<std::string> fractions;
  std::map<std::string, double> parameters;
  Frame frame;
  std::vector<Reference> references;
  Tables tables;
  std::vector<FormulaProgram> programs;
};

Material::Material(const std::vector<std::string>& fractions, const std::map<std::string, double>& parameters,
                   const Frame& frame, const std::vector<Reference>& references, const Tables& tables) {
  check_frame(frame);
  std::vector<FormulaProgram> programs =
      programs_of(fractions, checked(parameters), references, tables.size());
  state_ = std::make_unique<const State>(
      State{fractions, parameters, frame, references, tables, std::move(programs)});
}

Material::Material(Material&&) noexcept = default;
Material::~Material() = default;

int Material::constituents() const { return static_cast<int>(state_->programs.size()) + 1; }

void Material::evaluate(const Vec3* points, std::size_t count, double* fractions) const {
  const PointVariables variables(state_->frame, state_->references, state_->tables, points);
  for (std::size_t i = 0; i < state_->programs.size(); ++i)
    state_->programs[i].evaluate(variables, count, fractions + i * count);
}

void Material::evaluate(const Vec3* points, std::size_t count, double* fractions, Vec3* gradients) const {
  const PointVariables variables(state_->frame, state_->references, state_->tables, points);
  for (std::size_t i = 0; i < state_->programs.size(); ++i)
    state_->programs[i].evaluate(variables, count, fractions + i * count, gradients + i * count);
}

void Material::evaluate_at(const Vec3* points, const double* distances, std::size_t count,
                           double* fractions) const {
  const PointVariables variables(state_->frame, state_->references, state_->tables, points, distances);
  for (std::size_t i = 0; i < state_->programs.size(); ++i)
    state_->programs[i].evaluate(variables, count, fractions + i * count);
}

void Material::bounds(const Box& box, double* low, double* high) const {
  for (const FormulaProgram& program : state_->programs) {
    std::vector<Interval> inputs;
    for (const Variable variable : program.variables()) {
      inputs.push_back(variable_bounds(state_->frame, state_->references, state_->tables, box, variable));
    }
    const Interval result = program.bounds(inputs);
    const bool defined = !result.is_empty();
    *low++ = defined ? result.low : std::numeric_limits<double>::quiet_NaN();
    *high++ = defined ? result.high : std::numeric_limits<double>::quiet_NaN();
  }
}

void Material::tet_bounds(const Corners& tet, double* low, double* high, Vec3* slope_low,
                          Vec3* slope_high) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  boost::container::small_vector<DualInterval, 8> inputs;
  for (const FormulaProgram& program : state_->programs) {
    inputs.clear();
    for (const Variable variable : program.variables())
      inputs.push_back(variable_tet_bounds(state_->frame, state_->references, state_->tables, tet, variable));
    const DualInterval result = program.dual_bounds(inputs.data());
    const bool defined = !result.value.is_empty();
    *low++ = defined ? result.value.low : kNaN;
    *high++ = defined ? result.value.high : kNaN;
    for (int axis = 0; axis < 3; ++axis) {
      (*slope_low)[axis] = defined ? result.slope[axis].low : kNaN;
      (*slope_high)[axis] = defined ? result.slope[axis].high : kNaN;
    }
    ++slope_low;
    ++slope_high;
  }
}

const std::vector<std::string>& Material::fractions() const { return state_->fractions; }
const std::map<std::string, double>& Material::parameters() const { return state_->parameters; }
const Frame& Material::frame() const { return state_->frame; }
const std::vector<Reference>& Material::references() const { return state_->references; }
const Tables& Material::tables() const { return state_->tables; }

}  // namespace fgmesh
