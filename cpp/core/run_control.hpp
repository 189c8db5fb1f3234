// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

#include "core/vec3.hpp"

namespace fgmesh {

/// What a caller holds while a run goes on in another thread: a way to stop it and a view of how
/// far it is. Every member may be called from any thread. The run polls; it never calls back.
class RunControl {
 public:
  struct Progress {
    /// "reading", "initial", "material", "geometry", "certificate", "second order"; "" before the start
    std::string stage;
    double fraction = 0.0;  ///< of this stage, in [0, 1]
    std::size_t tets = 0;   ///< tetrahedra in the mesh at this moment
    /// about as many are expected of the finished mesh; 0: not known (yet)
    std::size_t expected_tets = 0;
    std::optional<Vec3> place;  ///< where the stage is at work, mm, if it tells
  };

  /// Limits of 0 mean none. Seconds count from the construction of this object, or from the last
  /// call of this function.
  void set_limits(double seconds, double memory_mb);

  /// Seconds until the time limit, negative after it; infinite where there is none.
  double seconds_left() const;
  double memory_limit_mb() const { return limit_memory_mb_; }

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

  Progress progress() const;

  // --- for the stages, and for those who tell of a run in another process ---------------------

  void begin_stage(const std::string& name);
  void report(double fraction, std::size_t tets);
  void expect(std::size_t tets) { expected_tets_.store(tets, std::memory_order_relaxed); }

  void look_at(const Vec3& place);

  /// Throws Cancelled where the run is to stop. Cheap enough for every few hundred tetrahedra.
  void check();
  /// The same, and tells where the work is.
  void check_at(const Vec3& place) {
    look_at(place);
    check();
  }

  /// True where check() would throw; for code that must unwind by itself.
  bool should_stop();

  /// CGAL's refinement watches a flag of this kind. It is set by cancel().
  std::atomic<bool>& stop_flag() noexcept { return cancelled_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::atomic<bool> cancelled_{false};
  std::atomic<double> fraction_{0.0};
  std::atomic<std::size_t> tets_{0}, expected_tets_{0};
  mutable std::mutex stage_mutex_;
  std::string stage_;
  std::optional<Vec3> place_;
  Clock::time_point start_ = Clock::now();
  double limit_seconds_ = 0.0;
  double limit_memory_mb_ = 0.0;
  std::atomic<unsigned> polls_{0};
  std::string reason_ = "the run was cancelled";
};

/// Largest resident memory of this process so far, MB; 0 where the system does not tell. Not that of
/// getrusage(), which a child process inherits from the one that started it.
double peak_memory_mb();

}  // namespace fgmesh
