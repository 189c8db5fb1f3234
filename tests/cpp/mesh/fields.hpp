// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "core/composition_field.hpp"

namespace fgmesh::test {

/// Two constituents, the fraction of the first and its gradient functions of a point.
class FunctionField final : public CompositionField {
 public:
  using Value = std::function<double(const Vec3&)>;
  using Gradient = std::function<Vec3(const Vec3&)>;

  FunctionField(Value value, Gradient gradient) : value_(std::move(value)), gradient_(std::move(gradient)) {}

  double operator()(const Vec3& p) const { return value_(p); }

  int constituents() const override { return 2; }
  void evaluate(const Vec3* points, std::size_t count, double* values) const override {
    for (std::size_t i = 0; i < count; ++i) values[i] = value_(points[i]);
  }
  void evaluate(const Vec3* points, std::size_t count, double* values, Vec3* gradients) const override {
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = value_(points[i]);
      gradients[i] = gradient_(points[i]);
    }
  }
  void bounds(const Box&, double* low, double* high) const override {
    *low = -std::numeric_limits<double>::infinity();
    *high = std::numeric_limits<double>::infinity();
  }
  void tet_bounds(const Corners& tet, double* low, double* high, Vec3* slope_low,
                  Vec3* slope_high) const override {
    bounds(box_around(tet), low, high);
    slope_low->setConstant(*low);
    slope_high->setConstant(*high);
  }

 private:
  Value value_;
  Gradient gradient_;
};

/// Of each constituent but the last the fraction that a field of two has for its first.
class Mixture final : public CompositionField {
 public:
  explicit Mixture(std::vector<FunctionField> parts) : parts_(std::move(parts)) {}

  int constituents() const override { return static_cast<int>(parts_.size()) + 1; }
  void evaluate(const Vec3* points, std::size_t count, double* values) const override {
    for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].evaluate(points, count, values + i * count);
  }
  void evaluate(const Vec3* points, std::size_t count, double* values, Vec3* gradients) const override {
    for (std::size_t i = 0; i < parts_.size(); ++i)
      parts_[i].evaluate(points, count, values + i * count, gradients + i * count);
  }
  void bounds(const Box& box, double* low, double* high) const override {
    for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].bounds(box, low + i, high + i);
  }
  void tet_bounds(const Corners& tet, double* low, double* high, Vec3* slope_low,
                  Vec3* slope_high) const override {
    for (std::size_t i = 0; i < parts_.size(); ++i)
      parts_[i].tet_bounds(tet, low + i, high + i, slope_low + i, slope_high + i);
  }

 private:
  std::vector<FunctionField> parts_;
};

/// slope . p + offset.
inline FunctionField linear(const Vec3& slope, double offset = 0.0) {
  return {[=](const Vec3& p) { return slope.dot(p) + offset; }, [=](const Vec3&) { return slope; }};
}

inline FunctionField constant(double value) { return linear(Vec3::Zero(), value); }

/// g(x) with its derivative.
inline FunctionField along_x(std::function<double(double)> g, std::function<double(double)> derivative) {
  return {[=](const Vec3& p) { return g(p.x()); },
          [=](const Vec3& p) { return Vec3(derivative(p.x()), 0, 0); }};
}

/// 1 where x > place, else 0.
inline FunctionField jump(double place) {
  return along_x([=](double x) { return x > place ? 1.0 : 0.0; }, [](double) { return 0.0; });
}

/// g(d) with its derivative, d the distance from `centre`; the gradient at the centre itself is zero where
/// the derivative is finite, as CompositionField asks.
inline FunctionField radial(std::function<double(double)> g, std::function<double(double)> derivative,
                            const Vec3& centre = Vec3::Zero()) {
  return {[=](const Vec3& p) { return g((p - centre).norm()); },
          [=](const Vec3& p) {
            const double d = (p - centre).norm();
            return d > 0.0 ? Vec3(derivative(d) / d * (p - centre)) : Vec3(Vec3::Zero());
          }};
}

inline FunctionField exponential(double alpha, const Vec3& centre = Vec3::Zero()) {
  return radial([=](double d) { return std::exp(-alpha * d); },
                [=](double d) { return -alpha * std::exp(-alpha * d); }, centre);
}

}  // namespace fgmesh::test
