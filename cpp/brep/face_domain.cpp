// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/face_domain.hpp"

#include <algorithm>
#include <cmath>

namespace fgmesh::brep {
namespace {

// In cells: closer than this to a segment, rounding decides the side.
constexpr double rounding_band = 1e-7;
// The same for the true border, beside which every ten digits count.
constexpr double curve_band = 1e-10;

double squared_distance(double x, double y, double x0, double y0, double x1, double y1) {
  const double dx = x1 - x0, dy = y1 - y0;
  const double length2 = dx * dx + dy * dy;
  const double s = length2 > 0.0 ? std::clamp(((x - x0) * dx + (y - y0) * dy) / length2, 0.0, 1.0) : 0.0;
  const double ex = x0 + s * dx - x, ey = y0 + s * dy - y;
  return ex * ex + ey * ey;
}

}  // namespace

FaceDomain::FaceDomain(const FaceSamples& samples) : low_(samples.uv.front()), high_(samples.uv.front()) {
  for (const Uv& uv : samples.uv) {
    for (int k = 0; k < 2; ++k) {
      low_[k] = std::min(low_[k], uv[k]);
      high_[k] = std::max(high_[k], uv[k]);
    }
  }
  cells_ =
      static_cast<int>(std::clamp(4.0 * std::sqrt(static_cast<double>(samples.border.size())), 16.0, 128.0));
  const double scale_x = cells_ / std::max(high_[0] - low_[0], 1e-300);
  const double scale_y = cells_ / std::max(high_[1] - low_[1], 1e-300);
  for (const BorderSegment& s : samples.border) {
    // The deepest point of a smooth arc lies near its middle; twice that covers it wherever it is.
    const double band =
        s.free ? rounding_band + 2.0 * std::hypot(s.bulge[0] * scale_x, s.bulge[1] * scale_y) : 0.0;
    reach_ = std::max({reach_, band, rounding_band});
    segments_.push_back({(s.start[0] - low_[0]) * scale_x, (s.start[1] - low_[1]) * scale_y,
                         (s.end[0] - low_[0]) * scale_x, (s.end[1] - low_[1]) * scale_y, band, s.curve,
                         s.parameters});
  }
  places_.assign(static_cast<std::size_t>(cells_) * cells_, Place::outside);
  fill_rows();
  for (const Segment& segment : segments_) mark_border(segment);
}

void FaceDomain::mark_border(const Segment& s) {
  const double reach = std::max(s.band, rounding_band);
  const auto cell = [&](double x) { return std::clamp(static_cast<int>(std::floor(x)), 0, cells_ - 1); };
  const double half_cell = std::sqrt(0.5) + reach;
  for (int j = cell(std::min(s.y0, s.y1) - reach); j <= cell(std::max(s.y0, s.y1) + reach); ++j) {
    for (int i = cell(std::min(s.x0, s.x1) - reach); i <= cell(std::max(s.x0, s.x1) + reach); ++i) {
      if (squared_distance(i + 0.5, j + 0.5, s.x0, s.y0, s.x1, s.y1) > half_cell * half_cell) continue;
      places_[static_cast<std::size_t>(j) * cells_ + i] = Place::border;
    }
  }
}

/// Marks the cells whose middle is inside, by the parity of the border's crossings along each row.
void FaceDomain::fill_rows() {
  std::vector<double> crossings;
  for (int j = 0; j < cells_; ++j) {
    const double y = j + 0.5;
    crossings.clear();
    for (const Segment& s : segments_) {
      if ((s.y0 <= y) != (s.y1 <= y)) crossings.push_back(s.x0 + (y - s.y0) / (s.y1 - s.y0) * (s.x1 - s.x0));
    }
    std::sort(crossings.begin(), crossings.end());
    std::size_t passed = 0;
    for (int i = 0; i < cells_; ++i) {
      while (passed < crossings.size() && crossings[passed] <= i + 0.5) ++passed;
      if (passed % 2 == 1) places_[static_cast<std::size_t>(j) * cells_ + i] = Place::inside;
    }
  }
}

FaceDomain::Place FaceDomain::locate(const Uv& uv) const {
  const double x = (uv[0] - low_[0]) / std::max(high_[0] - low_[0], 1e-300) * cells_;
  const double y = (uv[1] - low_[1]) / std::max(high_[1] - low_[1], 1e-300) * cells_;
  if (x > 0.0 && y > 0.0 && x < cells_ && y < cells_) {
    const Place place = places_[static_cast<std::size_t>(y) * cells_ + static_cast<std::size_t>(x)];
    if (place != Place::border) return place;
  } else if (x < -reach_ || y < -reach_ || x > cells_ + reach_ || y > cells_ + reach_) {
    return Place::outside;
  }
  return locate_by_segments(x, y);
}

/// Where a point near a segment is: between it and the true border, beside both, or on the border.
FaceDomain::Side FaceDomain::side_of_curve(const Segment& s, double x, double y) const {
  const double dx = s.x1 - s.x0, dy = s.y1 - s.y0;
  const double length2 = dx * dx + dy * dy;
  if (s.curve.IsNull() || length2 <= 0.0) return Side::unknown;
  const double along = ((x - s.x0) * dx + (y - s.y0) * dy) / length2;
  // What is beyond the ends is the neighbours' business.
  if (along < 0.0 || along > 1.0) return Side::beside;
  // The point of the curve as far along the segment, by the secant method.
  double t = s.parameters[0] + along * (s.parameters[1] - s.parameters[0]);
  double rate = s.parameters[1] - s.parameters[0];  // of t, along the segment
  double last_t = 0.0, last_along = 0.0, height = 0.0, error = 0.0;
  for (int iteration = 0; iteration < 8; ++iteration) {
    const gp_Pnt2d at = s.curve->Value(t);
    const double cx = (at.X() - low_[0]) / std::max(high_[0] - low_[0], 1e-300) * cells_ - s.x0;
    const double cy = (at.Y() - low_[1]) / std::max(high_[1] - low_[1], 1e-300) * cells_ - s.y0;
    const double curve_along = (cx * dx + cy * dy) / length2;
    height = (cy * dx - cx * dy) / std::sqrt(length2);
    error = along - curve_along;
    if (std::abs(error) <= 1e-13) break;
    if (iteration > 0 && curve_along != last_along) rate = (t - last_t) / (curve_along - last_along);
    last_t = t;
    last_along = curve_along;
    t += rate * error;
  }
  if (!(std::abs(error) <= 1e-10)) return Side::unknown;
  const double own_height = ((y - s.y0) * dx - (x - s.x0) * dy) / std::sqrt(length2);
  if (std::abs(own_height - height) <= curve_band) return Side::on;
  const bool between = own_height * height > 0.0 && std::abs(own_height) < std::abs(height);
  return between ? Side::between : Side::beside;
}

FaceDomain::Place FaceDomain::locate_by_segments(double x, double y) const {
  bool odd = false, on_line = false;
  for (const Segment& s : segments_) {
    const double reach = std::max(s.band, rounding_band);
    const bool far = y < std::min(s.y0, s.y1) - reach || y > std::max(s.y0, s.y1) + reach ||
                     x < std::min(s.x0, s.x1) - reach || x > std::max(s.x0, s.x1) + reach;
    if (!far && squared_distance(x, y, s.x0, s.y0, s.x1, s.y1) <= reach * reach) {
      const Side side = s.band > 0.0 ? side_of_curve(s, x, y) : Side::on;
      if (side == Side::unknown) return Place::border;
      if (side == Side::on) on_line = true;
      if (side == Side::between) odd = !odd;
    }
    if ((s.y0 <= y) != (s.y1 <= y)) {
      odd ^= x < s.x0 + (y - s.y0) / (s.y1 - s.y0) * (s.x1 - s.x0);
    }
  }
  return odd || on_line ? Place::inside : Place::outside;
}

}  // namespace fgmesh::brep
