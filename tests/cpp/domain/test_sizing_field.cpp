// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "domain/sizing_field.hpp"

namespace fgmesh {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const SizingField kField = {0.08, 0.01, 4.0, 0.5};

double size(double slope) { return kField.at(slope * Vec3(2, -1, 2) / 3.0); }

TEST(SizingField, IsTheConstantOverTheSlope) {
  // Along the gradient an element of this size spans the constant (paper, equation 2.7).
  for (const double slope : {0.03, 0.1, 1.0, 5.0}) EXPECT_NEAR(size(slope) * slope, 0.08, 1e-15) << slope;
}

TEST(SizingField, StaysWithinItsBounds) {
  EXPECT_EQ(size(0.0), 4.0);
  for (double slope = 1e-300; slope < 1e300; slope *= 7.0) {
    EXPECT_GE(size(slope), 0.01);
    EXPECT_LE(size(slope), 4.0);
  }
  EXPECT_EQ(kField.at(Vec3(kInfinity, 0, 0)), 0.01);
  EXPECT_EQ(size(1e300), 0.01);
}

TEST(SizingField, FallsAsTheSlopeRises) {
  double last = kInfinity;
  for (double slope = 1e-3; slope < 100.0; slope *= 1.1) {
    EXPECT_LE(size(slope), last);
    last = size(slope);
  }
}

TEST(SizingField, IsFiniteForNoNumber) {
  const double found = kField.at(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_GE(found, 0.01);
  EXPECT_LE(found, 4.0);
}

}  // namespace
}  // namespace fgmesh
