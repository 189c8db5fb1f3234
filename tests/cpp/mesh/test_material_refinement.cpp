// SPDX-License-Identifier: GPL-3.0-or-later
// The second stage on solids and fields in closed form. Lengths in mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "mesh/steiner_points.hpp"
#include "refined_part.hpp"

namespace fgmesh {
namespace {

constexpr double kPi = 3.14159265358979323846;

// What issue and paper ask of the mesh after this stage.
constexpr double kSmallestAngle = 10.9, kLargestAngle = 164.0, kElementRatio = 16.0;

const auto kCube = std::make_shared<test::BoxSolid>(Box{Vec3::Constant(-10), Vec3::Constant(10)});
const auto kBall = std::make_shared<test::BallSolid>(10.0);
const auto kCylinder = std::make_shared<test::CylinderSolid>(10.0, 20.0);

struct Case {
  std::string name;
  std::shared_ptr<const test::AnalyticSolid> solid;
  test::FunctionField field;
  double threshold;
  double gradient_cubed;  ///< integral of |grad f|^3 over the solid; 0: the element ratio is not asked
};

/// Integral over the ball of radius 10 of g'(d)^3.
double over_ball(const std::function<double(double)>& slope) {
  constexpr int kSteps = 20000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double d = (i + 0.5) * 10.0 / kSteps;
    sum += 4.0 * kPi * d * d * std::pow(std::abs(slope(d)), 3) * 10.0 / kSteps;
  }
  return sum;
}

void PrintTo(const Case& part, std::ostream* stream) { *stream << part.name; }

std::vector<Case> cases() {
  const auto exponential_slope = [](double d) { return 0.15 * std::exp(-0.15 * d); };
  const test::FunctionField ramp = test::linear(Vec3(0.05, 0, 0), 0.5);
  return {
      {"CubeLinearCoarse", kCube, ramp, 0.5, 0.0},
      {"CubeLinear", kCube, ramp, 0.1, 8000.0 * std::pow(0.05, 3)},
      {"BallLinear", kBall, ramp, 0.1, 4.0 / 3.0 * kPi * 1000.0 * std::pow(0.05, 3)},
      {"BallExponentialCoarse", kBall, test::exponential(0.15), 0.5, 0.0},
      {"BallExponential", kBall, test::exponential(0.15), 0.1, over_ball(exponential_slope)},
      // A gradient that is not unique at the centre, and one that is infinite there.
      {"BallDistance", kBall, test::radial([](double d) { return d / 10; }, [](double) { return 0.1; }), 0.2,
       over_ball([](double) { return 0.1; })},
      {"BallRootOfDistance", kBall,
       test::radial([](double d) { return std::sqrt(d / 10); },
                    [](double d) { return 0.05 / std::sqrt(d / 10); }),
       0.2, 0.0},
      // One that vanishes, so that the largest size rules.
      {"BallSquare", kBall,
       test::radial([](double d) { return d * d / 100; }, [](double d) { return d / 50; }), 0.2, 0.0},
      {"CylinderCube",
       kCylinder,
       {[](const Vec3& p) { return std::pow(p.z() / 20, 3); },
        [](const Vec3& p) { return Vec3(0, 0, 3.0 / 20 * std::pow(p.z() / 20, 2)); }},
       0.1,
       0.0},
      {"CubeLayer", kCube,
       test::along_x([](double x) { return 0.5 + 0.5 * std::tanh(x / 3); },
                     [](double x) { return 0.5 / 3 / std::pow(std::cosh(x / 3), 2); }),
       0.2, 0.0},
  };
}

class MaterialRefinement : public testing::TestWithParam<Case> {};

TEST_P(MaterialRefinement, KeepsTheThresholdInGoodTetrahedraOnTheTrueBoundary) {
  const Case& part = GetParam();
  test::RefinedPart refined(*part.solid, part.field, part.threshold);
  refined.refine();
  const MeshState& state = refined.state;
  EXPECT_EQ(test::find_fault(state, *part.solid, 0.026), "");
  EXPECT_LE(test::largest_variation(state), part.threshold);
  EXPECT_EQ(count_above(state, part.threshold), 0);
  for (int v = 0; v < state.complex.vertex_slots(); ++v)
    if (state.complex.tet_at(v) >= 0) {
      EXPECT_EQ(state.vertices[v].own.composition[0], std::clamp(part.field(state.position(v)), 0.0, 1.0));
    }
  const AngleRange angles = test::angle_range(state);
  EXPECT_GE(angles.smallest, kSmallestAngle);
  EXPECT_LE(angles.largest, kLargestAngle);
  EXPECT_NEAR(test::volume_of(state), part.solid->volume(), 0.05 * part.solid->volume());
  if (part.gradient_cubed > 0.0) {
    const double ratio = state.complex.tet_count() * std::pow(part.threshold, 3) / part.gradient_cubed;
    RecordProperty("element_ratio", std::to_string(ratio));
    EXPECT_LE(ratio, kElementRatio);
    EXPECT_GE(ratio, 3.0) << "no isotropic mesh has fewer tetrahedra";
  }
}

TEST(MaterialRefinementOfThreeConstituents, KeepsTheThresholdOfTheWholeComposition) {
  const test::FunctionField first = test::linear(Vec3(0.025, 0, 0), 0.25);
  const test::FunctionField second =
      test::radial([](double d) { return d * d / 900; }, [](double d) { return d / 450; });
  const test::Mixture mixture({first, second});
  test::RefinedPart refined(*kCube, mixture, 0.1);
  refined.refine();
  const MeshState& state = refined.state;
  EXPECT_EQ(test::find_fault(state, *kCube, 0.026), "");
  double largest = 0.0;
  for (int t = 0; t < state.complex.slots(); ++t) {
    if (!state.complex.tet(t).alive()) continue;
    for (const auto& [i, j] : kEdgeVertices) {
      const Vec3 &p = state.position(state.complex.tet(t).vertex[i]),
                 &q = state.position(state.complex.tet(t).vertex[j]);
      const double a = first(q) - first(p), b = second(q) - second(p);
      largest = std::max(largest, std::sqrt(a * a + b * b + (a + b) * (a + b)));
    }
  }
  EXPECT_LE(largest, 0.1);
  EXPECT_GT(largest, 0.09);
  EXPECT_NEAR(test::largest_variation(state), largest, 1e-12);
  EXPECT_GE(test::angle_range(state).smallest, kSmallestAngle);
}

TEST_P(MaterialRefinement, KeepsTheThresholdInStretchedTetrahedra) {
  const Case& part = GetParam();
  test::RefinedPart refined(*part.solid, part.field, part.threshold);
  refined.refine(3.0);
  const MeshState& state = refined.state;
  EXPECT_EQ(test::find_fault(state, *part.solid, 0.026), "");
  EXPECT_LE(test::largest_variation(state), part.threshold);
  const AngleRange angles = test::angle_range(state);
  EXPECT_GE(angles.smallest, 8.0);
  EXPECT_LE(angles.largest, 167.0);
  EXPECT_NEAR(test::volume_of(state), part.solid->volume(), 0.05 * part.solid->volume());
  if (part.gradient_cubed > 0.0) {
    EXPECT_LE(state.complex.tet_count() * std::pow(part.threshold, 3) / part.gradient_cubed, 5.0);
  }
}

/// Mean extents of the tetrahedra along x, y and z.
Vec3 mean_extents(const MeshState& state) {
  Vec3 sum = Vec3::Zero();
  for (int t = 0; t < state.complex.slots(); ++t) {
    if (!state.complex.tet(t).alive()) continue;
    const auto at = [&](int i) -> const Vec3& { return state.position(state.complex.tet(t).vertex[i]); };
    sum += at(0).cwiseMax(at(1)).cwiseMax(at(2)).cwiseMax(at(3)) -
           at(0).cwiseMin(at(1)).cwiseMin(at(2)).cwiseMin(at(3));
  }
  return sum / state.complex.tet_count();
}

TEST(StretchedMaterialRefinement, MakesElementsLongerAcrossTheGradientOnly) {
  const test::FunctionField ramp = test::linear(Vec3(0.05, 0, 0), 0.5);
  test::RefinedPart isotropic(*kCube, ramp, 0.1), stretched(*kCube, ramp, 0.1);
  isotropic.refine();
  stretched.refine(3.0);
  const Vec3 alike = mean_extents(isotropic.state), longer = mean_extents(stretched.state);
  EXPECT_NEAR(longer.x(), alike.x(), 0.2 * alike.x());
  for (int axis : {1, 2}) {
    EXPECT_GT(longer[axis], 1.7 * longer.x());
    EXPECT_LT(longer[axis], 3.5 * longer.x());
    EXPECT_LT(alike[axis], 1.5 * alike.x());
  }
}

INSTANTIATE_TEST_SUITE_P(Of, MaterialRefinement, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name; });

TEST(MaterialRefinementOfAConstant, InsertsNothing) {
  const test::FunctionField field = test::constant(0.3);
  test::RefinedPart part(*kCube, field, 0.1);
  const int before = test::vertex_count(part.state);
  part.refine();
  EXPECT_EQ(test::vertex_count(part.state), before);
  EXPECT_EQ(test::largest_variation(part.state), 0.0);
  EXPECT_EQ(test::find_fault(part.state, *kCube), "");
  EXPECT_GE(test::angle_range(part.state).smallest, kSmallestAngle);
}

TEST(MaterialRefinementOfAJump, EndsWithTheTetrahedraAcrossItAboveAndNoOther) {
  constexpr double kPlace = 1.234;
  const test::FunctionField field = test::jump(kPlace);
  test::RefinedPart part(*kCube, field, 0.1);
  part.refine();
  EXPECT_EQ(test::find_fault(part.state, *kCube), "");
  const TetComplex& complex = part.state.complex;
  int above = 0;
  for (int t = 0; t < complex.slots(); ++t) {
    if (!complex.tet(t).alive()) continue;
    double low = 10.0, high = -10.0;
    for (const int v : complex.tet(t).vertex) {
      low = std::min(low, part.state.position(v).x());
      high = std::max(high, part.state.position(v).x());
    }
    const bool crosses = low <= kPlace && high > kPlace;
    EXPECT_EQ(part.state.variation(t) > 0.1, crosses);
    above += crosses;
  }
  EXPECT_GT(above, 50);
  EXPECT_LT(complex.tet_count(), 20000) << "a jump is not to be refined for ever";
  EXPECT_GE(test::angle_range(part.state).smallest, kSmallestAngle);
}

TEST(MaterialRefinementThatIsCancelled, Stops) {
  const test::FunctionField field = test::exponential(0.15);
  test::RefinedPart part(*kBall, field, 0.1);
  part.control.cancel();
  EXPECT_THROW(part.refine(), Cancelled);
  EXPECT_EQ(test::find_fault(part.state, *kBall), "") << "what is left must be a mesh";
}

}  // namespace
}  // namespace fgmesh
