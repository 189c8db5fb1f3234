// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>

#include "core/vec3.hpp"

namespace fgmesh::brep {

inline std::uint64_t next_field_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

/// The distance of a field at a point, and its gradient: from `compute(gradient)`, or as this thread has
/// found it not long ago. The pieces that a tetrahedron is divided into have most of their corners in common,
/// and distances are slow.
template <class Compute>
double recent(std::uint64_t field, const Vec3& point, Vec3& gradient, const Compute& compute) {
  struct Entry {
    std::uint64_t field = 0;
    Vec3 point, gradient;
    double value = 0.0;
  };
  static thread_local std::array<Entry, 1024> entries;
  std::uint64_t hash = field;
  for (const double x : point) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 29;
  }
  Entry& entry = entries[hash % entries.size()];
  if (entry.field != field || entry.point != point) {
    entry.value = compute(entry.gradient);
    entry.field = field;
    entry.point = point;
  }
  gradient = entry.gradient;
  return entry.value;
}

}  // namespace fgmesh::brep
