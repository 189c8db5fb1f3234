// SPDX-License-Identifier: GPL-3.0-or-later
// A run is cancelled once it is in a stage, and must end soon.
#include <gtest/gtest.h>

#include <chrono>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "material/material.hpp"
#include "occt_shapes.hpp"
#include "pipeline/generate_mesh.hpp"

namespace fgmesh {
namespace {

using Clock = std::chrono::steady_clock;

/// What users are promised.
constexpr double kLargestDelay = 2.0;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct EndlessRun {
  std::string name;  ///< the stage to cancel it in
  std::string shape;
  std::string formula;
  MeshingOptions options;  ///< such that the stage lasts far longer than the test
  double wait;             ///< seconds in that stage before cancel()
};

void PrintTo(const EndlessRun& run, std::ostream* stream) { *stream << run.name; }

std::vector<EndlessRun> runs() {
  MeshingOptions endless_initial, endless_material, endless_geometry;
  endless_initial.max_size = 0.02;
  endless_material.material_threshold = 0.002;
  endless_geometry.material_threshold = 0.5;
  endless_geometry.surface_deviation = 2e-6;
  endless_geometry.min_size = 1e-6;
  std::vector<EndlessRun> all;
  for (const double wait : {0.0, 0.7, 2.0}) {
    all.push_back({"initial", test::ball_text(5.0), "0.5", endless_initial, wait});
    all.push_back({"material", test::box_text(10, 10, 10), "x/10", endless_material, wait});
    all.push_back({"geometry", test::ball_text(10.0), "x/40 + 0.5", endless_geometry, wait});
  }
  return all;
}

class Cancel : public testing::TestWithParam<EndlessRun> {};

TEST_P(Cancel, EndsTheRunSoon) {
  const EndlessRun& run = GetParam();
  const Material material({run.formula});
  RunControl control;
  std::string message;
  std::thread worker([&] {
    try {
      generate_mesh(run.shape, material, run.options, control);
      message = "it came to its end";
    } catch (const Cancelled& error) {
      message = error.what();
    }
  });
  const auto start = Clock::now();
  while (control.progress().stage != run.name && seconds_since(start) < 30.0)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(control.progress().stage, run.name);
  std::this_thread::sleep_for(std::chrono::duration<double>(run.wait));
  const auto cancelled = Clock::now();
  control.cancel();
  worker.join();
  const double delay = seconds_since(cancelled);
  RecordProperty("seconds", std::to_string(delay));
  EXPECT_LT(delay, kLargestDelay);
  EXPECT_NE(message.find("cancelled"), std::string::npos) << message;
  EXPECT_NE(message.find(run.name), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(In, Cancel, testing::ValuesIn(runs()), [](const auto& info) {
  return info.param.name + "After" + std::to_string(static_cast<int>(1000 * info.param.wait)) + "ms";
});

TEST(Limits, OfTimeEndARun) {
  RunControl control;
  MeshingOptions options;
  options.material_threshold = 0.002;
  const auto start = Clock::now();
  control.set_limits(0.5, 0.0);
  try {
    generate_mesh(test::box_text(10, 10, 10), Material({"x/10"}), options, control);
    FAIL() << "it came to its end";
  } catch (const Cancelled& error) {
    EXPECT_NE(std::string(error.what()).find("time limit"), std::string::npos) << error.what();
  }
  EXPECT_GE(seconds_since(start), 0.5);
  EXPECT_LT(seconds_since(start), 0.5 + kLargestDelay);
}

TEST(Limits, OfMemoryEndARun) {
  RunControl control;
  MeshingOptions options;
  options.material_threshold = 0.002;
  control.set_limits(0.0, peak_memory_mb() + 20.0);
  try {
    generate_mesh(test::box_text(10, 10, 10), Material({"x/10"}), options, control);
    FAIL() << "it came to its end";
  } catch (const Cancelled& error) {
    EXPECT_NE(std::string(error.what()).find("memory limit"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace fgmesh
