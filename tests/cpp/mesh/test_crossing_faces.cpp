// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "mesh/crossing_faces.hpp"

namespace fgmesh {
namespace {

/// Two balls, Face1 about the origin with radius 1, Face2 elsewhere; coarse triangles, those of the second
/// turned about z so that they do not follow those of the first.
class TwoBalls : public BoundaryGeometry {
 public:
  TwoBalls(const Vec3& centre, double radius, int solid_of_second = 1)
      : centres_{Vec3::Zero(), centre}, radii_{1.0, radius}, solid_of_second_(solid_of_second) {}

  SurfacePoint project_to_face(int face, const Vec3& p, const double*) const override {
    const Vec3 normal = (p - centres_[face - 1]).normalized();
    return {centres_[face - 1] + radii_[face - 1] * normal, normal, 0.0, 0.0};
  }
  CurvePoint project_to_edge(int, const Vec3& p, const double*) const override { return {p, {}, 0.0}; }
  Vec3 vertex_position(int) const override { return Vec3::Zero(); }
  bool contains(const Vec3&, int, bool) const override { return false; }

  SampledBoundary samples() const {
    constexpr int rings = 6, sides = 10;
    SampledBoundary boundary;
    for (int face = 1; face <= 2; ++face) {
      const int first = static_cast<int>(boundary.points.size());
      for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < sides; ++j) {
          const double polar = M_PI * (i + 0.5) / (rings + 1);
          const double azimuth = 2.0 * M_PI * j / sides + 0.3 * face;
          boundary.points.push_back(centres_[face - 1] +
                                    radii_[face - 1] * Vec3(std::sin(polar) * std::cos(azimuth),
                                                            std::sin(polar) * std::sin(azimuth),
                                                            std::cos(polar)));
        }
      const auto add = [&](int a, int b, int c) {
        boundary.triangles.push_back({first + a, first + b, first + c});
        boundary.triangle_face.push_back(face);
        boundary.triangle_solids.push_back({face == 1 ? 1 : solid_of_second_, 0});
      };
      for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sides; ++j) {
          const int next = (j + 1) % sides;
          add(i * sides + j, (i + 1) * sides + j, (i + 1) * sides + next);
          add(i * sides + j, (i + 1) * sides + next, i * sides + next);
        }
    }
    boundary.bounds = {Vec3::Constant(-1.0), centres_[1] + Vec3::Constant(radii_[1])};
    return boundary;
  }

 private:
  Vec3 centres_[2];
  double radii_[2];
  int solid_of_second_;
};

std::string refusal(const TwoBalls& balls) {
  RunControl control;
  try {
    require_no_crossing_faces(balls.samples(), balls, control);
  } catch (const GeometryError& error) {
    return error.what();
  }
  return {};
}

TEST(CrossingFaces, BallsThatCrossAreNamedWithAPointOfBoth) {
  const Vec3 centre(1.2, 0.3, 0.1);
  const std::string text = refusal({centre, 0.7});
  ASSERT_EQ(text.find("Face1 and Face2 cross or touch each other near ("), 0u) << text;
  Vec3 point;
  ASSERT_EQ(std::sscanf(text.c_str() + text.find('('), "(%lf, %lf, %lf)", &point.x(), &point.y(), &point.z()),
            3);
  EXPECT_NEAR(point.norm(), 1.0, 1e-5);
  EXPECT_NEAR((point - centre).norm(), 0.7, 1e-5);
}

TEST(CrossingFaces, CoincidentBallsAreRefused) {
  EXPECT_EQ(refusal({Vec3::Zero(), 1.0}).find("Face1 and Face2"), 0u);
}

TEST(CrossingFaces, BallsOfTwoSolidsMayTouch) {
  // The first ball touches the second from within, at (-1, 0, 0).
  const Vec3 centre(0.3, 0.0, 0.0);
  EXPECT_NE(refusal({centre, 1.3}), "");
  EXPECT_EQ(refusal({centre, 1.3, 2}), "");
  // Where they cross they are refused all the same.
  EXPECT_NE(refusal({centre, 1.2, 2}), "");
}

class ThinWall : public testing::TestWithParam<double> {};

TEST_P(ThinWall, WhoseSamplesCutEachOtherIsNotRefused) {
  EXPECT_EQ(refusal({Vec3::Zero(), 1.0 + GetParam()}), "");
  EXPECT_EQ(refusal({Vec3::Zero(), 1.0 - GetParam()}), "");
  // Thicker on one side.
  EXPECT_EQ(refusal({Vec3(0.5 * GetParam(), 0.0, 0.0), 1.0 + GetParam()}), "");
}

INSTANTIATE_TEST_SUITE_P(CrossingFaces, ThinWall, testing::Values(0.03, 1e-2, 1e-3, 1e-4, 1e-5));

TEST(CrossingFaces, CancelledInBetween) {
  RunControl control;
  control.cancel();
  const TwoBalls balls(Vec3::Zero(), 1.001);
  EXPECT_THROW(require_no_crossing_faces(balls.samples(), balls, control), Cancelled);
}

}  // namespace
}  // namespace fgmesh
