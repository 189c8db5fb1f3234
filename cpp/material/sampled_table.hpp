// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "material/formula_names.hpp"
#include "material/interval.hpp"

namespace fgmesh {

/// Values on a rectilinear grid over one to three coordinates of a material's frame: linear in each of them
/// between samples, held constant outside of the grid. Immutable.
class SampledTable {
 public:
  static constexpr std::size_t kMaxCoordinates = 3;
  static constexpr std::size_t kMaxValues = 4'000'000;

  /// One direction of the grid.
  struct Axis {
    Variable coordinate;
    std::vector<double> places;  ///< ascending, two at least; mm, radians for the angle

    bool operator==(const Axis& other) const {
      return coordinate == other.coordinate && places == other.places;
    }
  };

  /// `values`: one for each place of the grid, those along the last axis side by side. Throws InvalidInput
  /// for numbers that make no grid.
  SampledTable(std::vector<Axis> axes, std::vector<double> values);

  const std::vector<Axis>& axes() const { return axes_; }
  const std::vector<double>& values() const { return values_; }

  bool operator==(const SampledTable& other) const {
    return axes_ == other.axes_ && values_ == other.values_;
  }

  /// At the coordinates of axes(); NaN where one of them is. Never beyond the samples around.
  double value(const double* coordinates) const;

  /// Derivative with respect to the coordinate of axes()[axis]: that of the next samples above at a sample,
  /// of those inside on the border of the grid, zero outside.
  double slope(const double* coordinates, std::size_t axis) const;

  /// Holds every value() of coordinates within `box`, an interval for each of axes(). As tight as rounding
  /// allows where the box touches some thousand samples at most; else as tight as blocks of samples are.
  Interval bounds(const Interval* box) const;

  /// Holds every slope() along axes()[axis] of coordinates within `box`; everything where the box touches too
  /// many samples.
  Interval slope_bounds(const Interval* box, std::size_t axis) const;

 private:
  /// A coordinate's cell, from one sample to the next, and how far in it: 0 at its low end, 1 at its high
  /// one.
  struct Station {
    std::size_t cell;
    double share;
  };
  using Stations = std::array<Station, kMaxCoordinates>;
  /// First and last index, both included.
  struct Span {
    std::size_t first;
    std::size_t last;
  };
  using Spans = std::array<Span, kMaxCoordinates>;

  Station station(std::size_t axis, double coordinate) const;
  Stations stations(const double* coordinates) const;
  double blended(const Stations& at, std::size_t axis, std::size_t offset) const;
  double difference(const Stations& at, std::size_t along, std::size_t axis, std::size_t offset) const;
  Interval sample_range(const Spans& samples) const;
  Interval corner_range(const Stations& low, const Stations& high) const;
  void make_blocks();

  std::vector<Axis> axes_;
  std::vector<double> values_;
  std::array<std::size_t, kMaxCoordinates> strides_{};
  // Ranges of blocks of block_size_ cells along each axis, for boxes that touch too many samples.
  std::vector<Interval> blocks_;
  std::array<std::size_t, kMaxCoordinates> block_size_{}, block_count_{};
};

}  // namespace fgmesh
