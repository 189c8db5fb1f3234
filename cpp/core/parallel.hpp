// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace fgmesh {

/// Runs `work` with at most `threads` threads for what it does at the same time, and no more than there are
/// processors; 0: with all of them.
template <class Work>
void with_threads(int threads, const Work& work) {
  const int processors = tbb::info::default_concurrency();
  tbb::task_arena arena(threads > 0 ? std::min(threads, processors) : processors);
  arena.execute(work);
}

/// How many threads with_threads() lets the caller use.
inline int threads_in_use() { return tbb::this_task_arena::max_concurrency(); }

/// Calls work(i) for each i below `count`, some at the same time. What one throws ends all.
template <class Work>
void for_each_at_once(int count, const Work& work) {
  tbb::parallel_for(
      tbb::blocked_range<int>(0, count, 1),
      [&](const tbb::blocked_range<int>& range) {
        for (int i = range.begin(); i < range.end(); ++i) work(i);
      },
      tbb::simple_partitioner());
}

/// Calls work(begin, end) for ranges that make up [0, count), some at the same time.
template <class Work>
void for_ranges_at_once(std::size_t count, const Work& work) {
  constexpr std::size_t kRange = 4096;
  for_each_at_once(static_cast<int>((count + kRange - 1) / kRange), [&](int i) {
    const std::size_t begin = i * kRange;
    work(begin, std::min(begin + kRange, count));
  });
}

}  // namespace fgmesh
