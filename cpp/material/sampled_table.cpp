// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/sampled_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "core/error.hpp"

namespace fgmesh {
namespace {

/// Samples, or blocks of samples, that bounds() looks at: some ten microseconds.
constexpr std::size_t kMaxScanned = 4096;

/// Differences of greater numbers might not be finite.
constexpr double kLargestNumber = 1e100;

/// Pi as a table may have rounded it.
constexpr double kLargestAngle = 3.15;

bool is_usable(double number) { return std::abs(number) <= kLargestNumber; }

void check_axis(const SampledTable::Axis& axis) {
  const std::string name(variable_name(axis.coordinate));
  const std::vector<double>& places = axis.places;
  if (places.size() < 2) {
    throw InvalidInput("the coordinate " + name +
                       " needs samples at two places at least: add some, or leave the coordinate out");
  }
  if (!std::all_of(places.begin(), places.end(), is_usable))
    throw InvalidInput("the coordinate " + name + " holds a number that is not finite, or larger than 1e100");
  if (std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) != places.end())
    throw InvalidInput("the places of the coordinate " + name + " must ascend: sort them, each once");
  if (axis.coordinate == Variable::kAngle &&
      std::max(std::abs(places.front()), std::abs(places.back())) > kLargestAngle) {
    throw InvalidInput("the angle theta goes from -pi to pi, but the table has samples from " +
                       std::to_string(places.front()) + " to " + std::to_string(places.back()) +
                       ": write radians in that range");
  }
}

void check_grid(const std::vector<SampledTable::Axis>& axes, const std::vector<double>& values) {
  if (axes.empty() || axes.size() > SampledTable::kMaxCoordinates) {
    throw InvalidInput("a table has values over one to three coordinates, not over " +
                       std::to_string(axes.size()));
  }
  std::size_t count = 1;
  for (auto axis = axes.begin(); axis != axes.end(); ++axis) {
    check_axis(*axis);
    for (auto other = axes.begin(); other != axis; ++other) {
      if (other->coordinate == axis->coordinate) {
        throw InvalidInput("the coordinate " + std::string(variable_name(axis->coordinate)) +
                           " stands there twice");
      }
    }
    if (axis->places.size() > SampledTable::kMaxValues / count) {
      throw InvalidInput("a table has at most " + std::to_string(SampledTable::kMaxValues) +
                         " values: take fewer samples");
    }
    count *= axis->places.size();
  }
  if (values.size() != count) {
    throw InvalidInput("the grid has " + std::to_string(count) + " places, but there are " +
                       std::to_string(values.size()) + " values: give one for each place");
  }
  if (!std::all_of(values.begin(), values.end(), is_usable))
    throw InvalidInput("the table holds a value that is not finite, or larger than 1e100");
}

/// Never beyond a and b, and exactly these at the ends.
double blend(double a, double b, double share) {
  return std::clamp((1.0 - share) * a + share * b, std::min(a, b), std::max(a, b));
}

/// Calls `body(indices)` for each place of a grid of one to three directions.
template <class Spans, class Body>
void for_each_place(const Spans& spans, Body body) {
  std::array<std::size_t, SampledTable::kMaxCoordinates> at{};
  for (at[0] = spans[0].first; at[0] <= spans[0].last; ++at[0])
    for (at[1] = spans[1].first; at[1] <= spans[1].last; ++at[1])
      for (at[2] = spans[2].first; at[2] <= spans[2].last; ++at[2]) body(at);
}

template <class Spans>
std::size_t place_count(const Spans& spans) {
  std::size_t count = 1;
  for (const auto& span : spans) count *= span.last - span.first + 1;
  return count;
}

void include(Interval& range, double value) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

}  // namespace

SampledTable::SampledTable(std::vector<Axis> axes, std::vector<double> values)
    : axes_(std::move(axes)), values_(std::move(values)) {
  check_grid(axes_, values_);
  std::size_t stride = 1;
  for (std::size_t axis = axes_.size(); axis-- > 0;) {
    strides_[axis] = stride;
    stride *= axes_[axis].places.size();
  }
  make_blocks();
}

SampledTable::Station SampledTable::station(std::size_t axis, double coordinate) const {
  const std::vector<double>& places = axes_[axis].places;
  if (coordinate <= places.front()) return {0, 0.0};
  if (coordinate >= places.back()) return {places.size() - 2, 1.0};
  // NaN is above no place and would end behind the last one.
  const auto above = std::upper_bound(places.begin(), places.end() - 1, coordinate);
  const double low = *(above - 1);
  return {static_cast<std::size_t>(above - places.begin()) - 1, (coordinate - low) / (*above - low)};
}

SampledTable::Stations SampledTable::stations(const double* coordinates) const {
  Stations at{};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) at[axis] = station(axis, coordinates[axis]);
  return at;
}

double SampledTable::blended(const Stations& at, std::size_t axis, std::size_t offset) const {
  if (axis == axes_.size()) return values_[offset];
  const std::size_t low = offset + at[axis].cell * strides_[axis];
  return blend(blended(at, axis + 1, low), blended(at, axis + 1, low + strides_[axis]), at[axis].share);
}

double SampledTable::difference(const Stations& at, std::size_t along, std::size_t axis,
                                std::size_t offset) const {
  const std::size_t low = offset + at[axis].cell * strides_[axis], high = low + strides_[axis];
  if (axis == along) return blended(at, axis + 1, high) - blended(at, axis + 1, low);
  const double a = difference(at, along, axis + 1, low), b = difference(at, along, axis + 1, high);
  return blend(a, b, at[axis].share);
}

double SampledTable::value(const double* coordinates) const { return blended(stations(coordinates), 0, 0); }

double SampledTable::slope(const double* coordinates, std::size_t axis) const {
  const std::vector<double>& places = axes_[axis].places;
  if (coordinates[axis] < places.front() || coordinates[axis] > places.back()) return 0.0;
  const Stations at = stations(coordinates);
  const std::size_t cell = at[axis].cell;
  return difference(at, axis, 0, 0) / (places[cell + 1] - places[cell]);
}

Interval SampledTable::bounds(const Interval* box) const {
  Stations low{}, high{};
  Spans samples{}, blocks{};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (box[axis].is_empty()) return Interval::empty();
    low[axis] = station(axis, box[axis].low);
    high[axis] = station(axis, box[axis].high);
    samples[axis] = {low[axis].cell, high[axis].cell + 1};
    blocks[axis] = {low[axis].cell / block_size_[axis], high[axis].cell / block_size_[axis]};
  }
  if (place_count(samples) <= kMaxScanned) {
    const Interval touched = sample_range(samples), corners = corner_range(low, high);
    // More than three blends err by.
    constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
    const double slack = kRounding * std::max(std::abs(touched.low), std::abs(touched.high));
    return intersection({corners.low - slack, corners.high + slack}, touched);
  }
  Interval range = Interval::empty();
  for_each_place(blocks, [&](const auto& at) {
    range = hull(range, blocks_[(at[0] * block_count_[1] + at[1]) * block_count_[2] + at[2]]);
  });
  return range;
}

Interval SampledTable::slope_bounds(const Interval* box, std::size_t along) const {
  Spans samples{};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    if (box[axis].is_empty()) return Interval::empty();
    samples[axis] = {station(axis, box[axis].low).cell, station(axis, box[axis].high).cell + 1};
  }
  if (place_count(samples) > kMaxScanned) return Interval::whole();
  const std::vector<double>& places = axes_[along].places;
  const bool inside = box[along].low >= places.front() && box[along].high <= places.back();
  Interval range = inside ? Interval::empty() : Interval::point(0.0);
  --samples[along].last;
  // Between samples the slope is a mean of those along the edges of the cell.
  for_each_place(samples, [&](const auto& at) {
    const double* const low = &values_[at[0] * strides_[0] + at[1] * strides_[1] + at[2] * strides_[2]];
    const double width = places[at[along] + 1] - places[at[along]];
    include(range, (low[strides_[along]] - *low) / width);
  });
  return widened(range.low, range.high);
}

Interval SampledTable::sample_range(const Spans& samples) const {
  Interval range = Interval::empty();
  for_each_place(samples, [&](const auto& at) {
    include(range, values_[at[0] * strides_[0] + at[1] * strides_[1] + at[2] * strides_[2]]);
  });
  return range;
}

/// What a function that is linear in each direction takes on in a box: its extremes are at the corners of the
/// parts into which samples divide the box.
Interval SampledTable::corner_range(const Stations& low, const Stations& high) const {
  Spans cells{};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) cells[axis] = {low[axis].cell, high[axis].cell + 1};
  Interval range = Interval::empty();
  for_each_place(cells, [&](const auto& at) {
    Stations corner{};
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      // The low end of each cell, but for the ends of the box.
      corner[axis] = at[axis] == cells[axis].first  ? low[axis]
                     : at[axis] == cells[axis].last ? high[axis]
                                                    : Station{at[axis], 0.0};
    }
    include(range, blended(corner, 0, 0));
  });
  return range;
}

void SampledTable::make_blocks() {
  // As many along each axis as together make kMaxScanned.
  const double most = std::floor(std::pow(kMaxScanned, 1.0 / static_cast<double>(axes_.size())) + 1e-9);
  Spans all{};
  for (std::size_t axis = 0; axis < kMaxCoordinates; ++axis) {
    const std::size_t cells = axis < axes_.size() ? axes_[axis].places.size() - 1 : 1;
    block_size_[axis] = (cells - 1) / static_cast<std::size_t>(most) + 1;
    block_count_[axis] = (cells - 1) / block_size_[axis] + 1;
    all[axis] = {0, block_count_[axis] - 1};
  }
  blocks_.reserve(place_count(all));
  for_each_place(all, [&](const auto& at) {
    Spans samples{};
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      const std::size_t first = at[axis] * block_size_[axis];
      samples[axis] = {first, std::min(first + block_size_[axis], axes_[axis].places.size() - 1)};
    }
    blocks_.push_back(sample_range(samples));
  });
}

}  // namespace fgmesh
