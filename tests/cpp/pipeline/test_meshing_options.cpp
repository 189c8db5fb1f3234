// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "core/error.hpp"
#include "pipeline/meshing_options.hpp"

namespace fgmesh {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Bad {
  std::string option;  ///< that the message must name
  std::function<void(MeshingOptions&)> set;
};

TEST(MeshingOptions, RefuseEachBadValueByName) {
  std::vector<Bad> bad;
  for (const double value : {0.0, -0.1, 1.0001, kNan, kInfinity})
    bad.push_back({"material_threshold", [=](MeshingOptions& o) { o.material_threshold = value; }});
  for (const double value : {-1e-9, -1.0, kNan, kInfinity, -kInfinity}) {
    bad.push_back({"surface_deviation", [=](MeshingOptions& o) { o.surface_deviation = value; }});
    bad.push_back({"min_size", [=](MeshingOptions& o) { o.min_size = value; }});
    bad.push_back({"max_size", [=](MeshingOptions& o) { o.max_size = value; }});
  }
  bad.push_back({"min_size", [](MeshingOptions& o) {
                   o.min_size = 2.0;
                   o.max_size = 1.0;
                 }});
  for (const double value : {0.0, 0.999, -2.0, kNan, kInfinity, 10.001})
    bad.push_back({"anisotropy", [=](MeshingOptions& o) { o.anisotropy = value; }});
  for (const int value : {0, 3, -1}) bad.push_back({"order", [=](MeshingOptions& o) { o.order = value; }});
  for (const char* value : {"", "Initial", "geometry ", "end"})
    bad.push_back({"stop_after", [=](MeshingOptions& o) { o.stop_after = value; }});
  bad.push_back({"threads", [](MeshingOptions& o) { o.threads = -1; }});

  for (const Bad& entry : bad) {
    MeshingOptions options;
    entry.set(options);
    try {
      options.validate();
      ADD_FAILURE() << "a bad " << entry.option << " went through";
    } catch (const InvalidInput& error) {
      EXPECT_NE(std::string(error.what()).find(entry.option), std::string::npos) << error.what();
    }
  }
}

TEST(MeshingOptions, TakeEachGoodValue) {
  EXPECT_NO_THROW(MeshingOptions().validate());
  MeshingOptions options;
  for (const double value : {1e-6, 0.5, 1.0}) {
    options.material_threshold = value;
    EXPECT_NO_THROW(options.validate());
  }
  options.min_size = options.max_size = 1.0;
  options.surface_deviation = 1e-9;
  options.threads = 64;
  options.seed = 7;
  EXPECT_NO_THROW(options.validate());
  options.max_size = 0.0;  // the default, which depends on the part
  EXPECT_NO_THROW(options.validate());
  for (const int order : {1, 2}) {
    options.order = order;
    EXPECT_NO_THROW(options.validate());
  }
  for (const char* stage : {"initial", "material", "geometry"}) {
    options.stop_after = stage;
    EXPECT_NO_THROW(options.validate());
  }
}

}  // namespace
}  // namespace fgmesh
