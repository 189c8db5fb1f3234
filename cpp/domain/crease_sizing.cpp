// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/crease_sizing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fgmesh {
namespace {

/// A segment may turn by this much, radians: 8 segments on a full circle.
constexpr double kTurn = 0.8;
/// Segments grow by at most this much, mm a mm, along a crease.
constexpr double kGrowth = 0.5;

std::array<double, 3> key(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

CreaseSizing::CreaseSizing(const SampledBoundary& samples, double size) : samples_(samples), largest_(size) {
  for (const SampledBoundary::Curve& curve : samples.curves) size_.emplace_back(curve.points.size(), size);
  limit_by_curvature();
  limit_by_distance();
  limit_growth();
  for (std::size_t c = 0; c < size_.size(); ++c) {
    const std::vector<int>& line = samples.curves[c].points;
    for (const std::size_t end : {std::size_t{0}, line.size() - 1}) {
      const auto place = corner_size_.emplace(key(samples.points[line[end]]), size).first;
      place->second = std::min(place->second, size_[c][end]);
    }
  }
}

void CreaseSizing::limit_by_curvature() {
  for (std::size_t c = 0; c < size_.size(); ++c) {
    const std::vector<int>& line = samples_.curves[c].points;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Vec3 before = samples_.points[line[i]] - samples_.points[line[i - 1]];
      const Vec3 after = samples_.points[line[i + 1]] - samples_.points[line[i]];
      const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
      if (angle <= 0.0) continue;
      const double radius = 0.5 * (before.norm() + after.norm()) / angle;
      for (std::size_t j = i - 1; j <= i + 1; ++j) size_[c][j] = std::min(size_[c][j], kTurn * radius);
    }
  }
}

void CreaseSizing::limit_by_distance() {
  const auto touch = [&](const std::vector<int>& a, const std::vector<int>& b) {
    return a.front() == b.front() || a.front() == b.back() || a.back() == b.front() || a.back() == b.back();
  };
  for (std::size_t c = 0; c < size_.size(); ++c) {
    const std::vector<int>& line = samples_.curves[c].points;
    for (std::size_t other = 0; other < size_.size(); ++other) {
      const std::vector<int>& far = samples_.curves[other].points;
      if (other == c || touch(line, far)) continue;
      for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3& p = samples_.points[line[i]];
        for (std::size_t j = 1; j < far.size(); ++j) {
          const Vec3& a = samples_.points[far[j - 1]];
          const Vec3 ab = samples_.points[far[j]] - a;
          const double s = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-300), 0.0, 1.0);
          size_[c][i] = std::min(size_[c][i], (a + s * ab - p).norm());
        }
      }
    }
  }
}

void CreaseSizing::limit_growth() {
  for (std::size_t c = 0; c < size_.size(); ++c) {
    const std::vector<int>& line = samples_.curves[c].points;
    const auto relax = [&](std::size_t from, std::size_t to) {
      const double distance = (samples_.points[line[from]] - samples_.points[line[to]]).norm();
      size_[c][to] = std::min(size_[c][to], size_[c][from] + kGrowth * distance);
    };
    for (std::size_t i = 1; i < line.size(); ++i) relax(i - 1, i);
    for (std::size_t i = line.size() - 1; i > 0; --i) relax(i, i - 1);
  }
}

double CreaseSizing::on_curve(int curve, const Vec3& p) const {
  const std::vector<int>& line = samples_.curves[curve].points;
  double nearest = std::numeric_limits<double>::infinity(), size = largest_;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double distance = (samples_.points[line[i]] - p).squaredNorm();
    if (distance < nearest) {
      nearest = distance;
      size = size_[curve][i];
    }
  }
  return size;
}

double CreaseSizing::at_corner(const Vec3& p) const {
  const auto found = corner_size_.find(key(p));
  return found == corner_size_.end() ? largest_ : found->second;
}

}  // namespace fgmesh
