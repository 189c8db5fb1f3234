// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "core/run_control.hpp"

namespace fgmesh {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Polls until the control stops the run; gives the message, or "" after `patience` seconds.
std::string message_of_stop(RunControl& control, double patience = 10.0) {
  const auto start = Clock::now();
  while (seconds_since(start) < patience) {
    try {
      control.check();
    } catch (const Cancelled& error) {
      return error.what();
    }
  }
  return "";
}

TEST(RunControl, LetsARunGoOnUnlessItIsCancelled) {
  RunControl control;
  for (int i = 0; i < 1000; ++i) ASSERT_NO_THROW(control.check());
  EXPECT_FALSE(control.cancelled());
  EXPECT_FALSE(control.stop_flag().load());
  control.cancel();
  EXPECT_TRUE(control.cancelled());
  EXPECT_TRUE(control.should_stop());
  EXPECT_TRUE(control.stop_flag().load()) << "CGAL watches this flag";
  EXPECT_THROW(control.check(), Cancelled);
  EXPECT_THROW(control.check(), Cancelled) << "a cancelled run stays cancelled";
}

TEST(RunControl, NamesTheStageThatWasStopped) {
  RunControl control;
  control.begin_stage("material");
  control.cancel();
  const std::string message = message_of_stop(control);
  EXPECT_NE(message.find("cancelled"), std::string::npos) << message;
  EXPECT_NE(message.find("\"material\""), std::string::npos) << message;
}

TEST(RunControl, TellsWhereAStageIsAtWork) {
  RunControl control;
  EXPECT_FALSE(control.progress().place);
  control.begin_stage("initial");
  control.check_at(Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(control.progress().place, Vec3(1.0, 2.0, 3.0));
  control.begin_stage("material");
  EXPECT_FALSE(control.progress().place);
}

TEST(RunControl, StopsAtTheTimeLimitAndNotBefore) {
  constexpr double kLimit = 0.05;
  RunControl control;
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const auto start = Clock::now();
  control.set_limits(kLimit, 0.0);  // counts from here, not from the construction
  const std::string message = message_of_stop(control);
  EXPECT_GE(seconds_since(start), kLimit);
  EXPECT_NE(message.find("time limit"), std::string::npos) << message;
  EXPECT_TRUE(control.cancelled());
}

TEST(RunControl, StopsAtTheMemoryLimit) {
  RunControl control;
  control.set_limits(0.0, 0.5);  // no process is that small
  const std::string message = message_of_stop(control);
  EXPECT_NE(message.find("memory limit"), std::string::npos) << message;
}

TEST(RunControl, LimitsThatSufficeDoNotDisturb) {
  RunControl control;
  control.set_limits(1e4, 1e6);
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(control.should_stop());
  control.set_limits(0.0, 0.0);
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(control.should_stop());
}

TEST(RunControl, TellsItsLimits) {
  RunControl control;
  EXPECT_TRUE(std::isinf(control.seconds_left()));
  EXPECT_EQ(control.memory_limit_mb(), 0.0);
  control.set_limits(0.05, 250.0);
  EXPECT_EQ(control.memory_limit_mb(), 250.0);
  EXPECT_GT(control.seconds_left(), 0.0);
  EXPECT_LE(control.seconds_left(), 0.05);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_LT(control.seconds_left(), 0.0);
}

TEST(RunControl, TellsHowFarTheRunIs) {
  RunControl control;
  EXPECT_EQ(control.progress().stage, "");
  EXPECT_EQ(control.progress().fraction, 0.0);
  control.begin_stage("initial");
  control.report(0.75, 1234);
  EXPECT_EQ(control.progress().stage, "initial");
  EXPECT_EQ(control.progress().fraction, 0.75);
  EXPECT_EQ(control.progress().tets, 1234u);
  control.begin_stage("material");
  EXPECT_EQ(control.progress().stage, "material");
  EXPECT_EQ(control.progress().fraction, 0.0) << "of the new stage";
}

TEST(RunControl, StopsEveryThread) {
  RunControl control;
  control.begin_stage("material");
  std::vector<std::string> messages(4);
  std::vector<std::thread> workers;
  for (std::string& message : messages)
    workers.emplace_back([&control, &message] { message = message_of_stop(control); });
  for (std::size_t i = 0; i < 1000; ++i) {
    control.report(1e-3 * static_cast<double>(i), i);
    EXPECT_EQ(control.progress().stage, "material");
  }
  control.cancel();
  for (std::thread& worker : workers) worker.join();
  for (const std::string& message : messages) EXPECT_NE(message.find("cancelled"), std::string::npos);
}

TEST(PeakMemory, CountsWhatWasTouched) {
  constexpr std::size_t kBytes = 64 << 20;
  const double before = peak_memory_mb();
  EXPECT_GT(before, 1.0);
  {
    const std::vector<char> block(kBytes, 1);
    ASSERT_EQ(block[kBytes / 2], 1);
  }
  const double after = peak_memory_mb();
  EXPECT_GT(after, before + 50.0);
  EXPECT_LT(after, before + 200.0) << "the unit is MB";
}

}  // namespace
}  // namespace fgmesh
