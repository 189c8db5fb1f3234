// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "material_samples.hpp"

namespace fgmesh::test {
namespace {

/// Signed height above the plane x = `place`, as a shape might give it.
class Plane final : public ScalarField {
 public:
  explicit Plane(double place, bool is_signed) : place_(place), is_signed_(is_signed) {}

  void evaluate(const Vec3* points, std::size_t count, double* values) const override {
    for (std::size_t i = 0; i < count; ++i) values[i] = turn(points[i]) * (points[i].x() - place_);
  }
  void evaluate(const Vec3* points, std::size_t count, double* values, Vec3* gradients) const override {
    evaluate(points, count, values);
    for (std::size_t i = 0; i < count; ++i) gradients[i] = Vec3(turn(points[i]), 0, 0);
  }
  void bounds(const Box& box, double& low, double& high) const override {
    low = box.low.x() - place_;
    high = box.high.x() - place_;
  }

 private:
  double turn(const Vec3& p) const { return !is_signed_ && p.x() < place_ ? -1.0 : 1.0; }
  double place_;
  bool is_signed_;
};

/// A solid below x = 2, and a face at x = 10.
std::vector<Reference> references() {
  return {{"Solid1", true, std::make_shared<Plane>(2.0, true)},
          {"Face3", false, std::make_shared<Plane>(10.0, false)}};
}

Material material(const std::string& formula) {
  return Material({formula}, {}, rotated_frame(), references());
}

TEST(MaterialReferences, AreVariables) {
  const Vec3 inside(-1.0, 5.0, 5.0), outside(6.0, 5.0, 5.0);
  EXPECT_EQ(value_at(material("s1"), inside), -3.0);
  EXPECT_EQ(value_at(material("d1"), inside), 3.0);
  EXPECT_EQ(value_at(material("d1"), outside), 4.0);
  EXPECT_EQ(value_at(material("d2"), outside), 4.0);
  EXPECT_DOUBLE_EQ(value_at(material("(d1/(d1 + d2))^2"), outside), 0.25);
  EXPECT_EQ(value_at(material("s1 + 10*d1 + 100*d2"), inside), -3.0 + 30.0 + 1100.0);
}

TEST(MaterialReferences, HaveGradientsInTheWorld) {
  const Vec3 inside(-1.0, 5.0, 5.0), outside(6.0, 5.0, 5.0);
  EXPECT_EQ(gradient_at(material("s1"), inside), Vec3(1, 0, 0));
  EXPECT_EQ(gradient_at(material("d1"), inside), Vec3(-1, 0, 0));
  EXPECT_EQ(gradient_at(material("d1"), outside), Vec3(1, 0, 0));
  // d1/(d1 + d2) = (x - 2)/8 between the two.
  EXPECT_LT((gradient_at(material("d1/(d1 + d2)"), outside) - Vec3(0.125, 0, 0)).norm(), 1e-15);
  // On the boundary of the solid the slope is that of its inside.
  EXPECT_EQ(gradient_at(material("d1"), Vec3(2, 0, 0)), Vec3(-1, 0, 0));
  EXPECT_EQ(gradient_at(material("s1"), Vec3(2, 0, 0)), Vec3(1, 0, 0));
}

TEST(MaterialReferences, HaveBounds) {
  const Box across{Vec3(-1, 0, 0), Vec3(5, 1, 1)};
  double low = 0.0, high = 0.0;
  material("s1").bounds(across, &low, &high);
  EXPECT_EQ(std::make_pair(low, high), std::make_pair(-3.0, 3.0));
  material("d1").bounds(across, &low, &high);
  EXPECT_EQ(std::make_pair(low, high), std::make_pair(0.0, 3.0));
}

TEST(MaterialReferences, SharesNoRegisterWithResults) {
  // Variables that come late must not land where an earlier result still waits.
  const Vec3 p(6.0, 5.0, 5.0);
  EXPECT_DOUBLE_EQ(value_at(material("exp(0.1*d2)*(1 + exp(d1*0 + s1*0.25))"), p),
                   std::exp(0.4) * (1.0 + std::exp(1.0)));
}

TEST(MaterialReferences, FaultsAreTold) {
  const struct {
    std::string formula, message;
    std::size_t position;
  } faults[] = {{"1 + d3", "only 2 are given", 4},
                {"s2", "is Face3; write d2", 0},
                {"d99999999999999999999", "only 2 are given", 0},
                {"d1(x)", "is no function", 2},
                {"d01", "unknown name", 0}};
  for (const auto& fault : faults) {
    try {
      material(fault.formula);
      ADD_FAILURE() << fault.formula;
    } catch (const FormulaError& error) {
      EXPECT_NE(std::string(error.what()).find(fault.message), std::string::npos) << error.what();
      EXPECT_EQ(error.position(), fault.position) << error.what();
    }
  }
}

}  // namespace
}  // namespace fgmesh::test
