// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run_control.hpp"

#include <unistd.h>

#include <cstdio>
#include <limits>

#include "core/error.hpp"

namespace fgmesh {
namespace {

/// Resident memory now, MB; 0 where the system does not tell.
double resident_memory_mb() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file) return 0.0;
  long total = 0, resident = 0;
  const int read = std::fscanf(file, "%ld %ld", &total, &resident);
  std::fclose(file);
  return read == 2 ? static_cast<double>(resident) * sysconf(_SC_PAGESIZE) / 1e6 : 0.0;
}

}  // namespace

double peak_memory_mb() {
  std::FILE* file = std::fopen("/proc/self/status", "r");
  if (!file) return 0.0;
  long kilobytes = 0;
  char line[256];
  while (std::fgets(line, sizeof line, file))
    if (std::sscanf(line, "VmHWM: %ld kB", &kilobytes) == 1) break;
  std::fclose(file);
  return static_cast<double>(kilobytes) * 1024.0 / 1e6;
}

void RunControl::set_limits(double seconds, double memory_mb) {
  start_ = Clock::now();
  limit_seconds_ = seconds;
  limit_memory_mb_ = memory_mb;
}

double RunControl::seconds_left() const {
  if (limit_seconds_ <= 0.0) return std::numeric_limits<double>::infinity();
  return limit_seconds_ - std::chrono::duration<double>(Clock::now() - start_).count();
}

RunControl::Progress RunControl::progress() const {
  Progress progress;
  {
    const std::lock_guard<std::mutex> lock(stage_mutex_);
    progress.stage = stage_;
    progress.place = place_;
  }
  progress.fraction = fraction_.load(std::memory_order_relaxed);
  progress.tets = tets_.load(std::memory_order_relaxed);
  progress.expected_tets = expected_tets_.load(std::memory_order_relaxed);
  return progress;
}

void RunControl::begin_stage(const std::string& name) {
  const std::lock_guard<std::mutex> lock(stage_mutex_);
  stage_ = name;
  place_.reset();
  fraction_.store(0.0, std::memory_order_relaxed);
}

void RunControl::report(double fraction, std::size_t tets) {
  fraction_.store(fraction, std::memory_order_relaxed);
  tets_.store(tets, std::memory_order_relaxed);
}

void RunControl::look_at(const Vec3& place) {
  const std::lock_guard<std::mutex> lock(stage_mutex_);
  place_ = place;
}

bool RunControl::should_stop() {
  if (cancelled()) return true;
  const bool has_limits = limit_seconds_ > 0.0 || limit_memory_mb_ > 0.0;
  // Reading the clock and /proc costs more than a few tetrahedra do: look at every 16th poll only.
  if (!has_limits || polls_.fetch_add(1, std::memory_order_relaxed) % 16 != 0) return false;
  const char* reached = nullptr;
  if (seconds_left() < 0.0) {
    reached = "the time limit was reached";
  } else if (limit_memory_mb_ > 0.0 && resident_memory_mb() > limit_memory_mb_) {
    reached = "the memory limit was reached";
  }
  if (!reached) return false;
  {
    const std::lock_guard<std::mutex> lock(stage_mutex_);
    reason_ = reached;
  }
  cancel();
  return true;
}

void RunControl::check() {
  if (!should_stop()) return;
  const std::lock_guard<std::mutex> lock(stage_mutex_);
  throw Cancelled(reason_ + (stage_.empty() ? "" : " in the stage \"" + stage_ + "\""));
}

}  // namespace fgmesh
