// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "material/material.hpp"
#include "quality/tet_certificate.hpp"

namespace fgmesh {
namespace {

constexpr int kMostPieces = 2000;

Composition fractions_at(const Material& material, const Vec3& p) {
  Composition value(material.constituents() - 1);
  material.evaluate(&p, 1, value.data());
  return value;
}

TetCertificate certificate_of(const Material& material, const Corners& tet, double threshold) {
  return certify_tet(material, tet,
                     {fractions_at(material, tet[0]), fractions_at(material, tet[1]),
                      fractions_at(material, tet[2]), fractions_at(material, tet[3])},
                     threshold, kMostPieces);
}

/// The largest difference between points of a fine grid in the tetrahedron.
double sampled_variation(const Material& material, const Corners& tet, int steps) {
  std::vector<Composition> values;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps - i; ++j)
      for (int k = 0; k <= steps - i - j; ++k) {
        const Vec3 place = (i * tet[0] + j * tet[1] + k * tet[2] + (steps - i - j - k) * tet[3]) / steps;
        const Composition value = fractions_at(material, place);
        values.push_back(value);  // a copy: g++ 12 warns of reading too much where it is moved
      }
  double largest = 0.0;
  for (const Composition& a : values)
    for (const Composition& b : values) largest = std::max(largest, difference(a, b));
  return largest;
}

double corner_variation(const Material& material, const Corners& tet) {
  return sampled_variation(material, tet, 1);
}

Corners tet_at(const Vec3& centre, double size, std::mt19937& random) {
  Corners tet{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  std::uniform_real_distribution<double> shake(-0.4, 0.4);
  for (Vec3& corner : tet)
    corner = centre + size * (corner + Vec3(shake(random), shake(random), shake(random)));
  return tet;
}

/// Against dense samples: what they exceed is never proved, what they keep with a little to spare always is.
void expect_right(const std::vector<std::string>& formulas, double size, int steps) {
  const Material material(formulas);
  std::mt19937 random(7);
  for (int i = 0; i < 25; ++i) {
    std::uniform_real_distribution<double> place(0.2, 1.0);
    const Corners tet = tet_at({place(random), place(random), place(random)}, size, random);
    const double sampled = sampled_variation(material, tet, steps);
    const TetCertificate kept = certificate_of(material, tet, 1.05 * sampled);
    EXPECT_EQ(kept.proof, Proof::kProved) << formulas[0] << ' ' << i << " after " << kept.pieces;
    EXPECT_GE(kept.bound, sampled * (1.0 - 1e-12));
    EXPECT_LE(kept.bound, 1.05 * sampled * (1.0 + kCertificateRounding));
    const TetCertificate broken = certificate_of(material, tet, 0.95 * sampled);
    EXPECT_EQ(broken.proof, Proof::kBroken) << formulas[0] << ' ' << i << " after " << broken.pieces;
    const auto& [p, q] = broken.apart;
    EXPECT_GT(difference(fractions_at(material, p), fractions_at(material, q)), 0.95 * sampled);
    EXPECT_NEAR(difference(fractions_at(material, p), fractions_at(material, q)), broken.variation, 1e-12);
  }
}

TEST(TetCertificate, AgreesWithDenseSamplesOnWaves) {
  expect_right({"0.5 + 0.4*sin(20*x)"}, 0.05, 14);
  expect_right({"0.5 + 0.2*sin(20*x) + 0.2*cos(13*y - 4*z)"}, 0.08, 14);
}

TEST(TetCertificate, AgreesWithDenseSamplesOnRoots) {
  expect_right({"sqrt(d)/2"}, 0.1, 14);
  expect_right({"sqrt(abs(x - 0.5) + 0.03)"}, 0.1, 14);
}

TEST(TetCertificate, AgreesWithDenseSamplesOnThreeConstituents) {
  expect_right({"0.3 + 0.2*sin(9*x)", "exp(-3*d)/2"}, 0.06, 9);
  expect_right({"x^2/4", "x/4"}, 0.1, 9);
}

TEST(TetCertificate, BreaksWhereCornersAgreeButTheInsideDoesNot) {
  const Corners tet{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  const Material bump({"exp(-4*d^2)"});
  EXPECT_LT(corner_variation(bump, tet), 1e-6);
  const TetCertificate found = certificate_of(bump, tet, 0.5);
  EXPECT_EQ(found.proof, Proof::kBroken);
  EXPECT_GT(found.variation, 0.5);
  const Material wave({"0.5 + 0.5*sin(2*pi*x)"});  // one value at all corners
  EXPECT_LT(corner_variation(wave, tet), 1e-6);
  EXPECT_EQ(certificate_of(wave, tet, 0.5).proof, Proof::kBroken);
}

TEST(TetCertificate, NeedsOnePieceWhereTheFractionRisesAllAlong) {
  std::mt19937 random(3);
  for (const char* formula : {"x/4", "exp(-0.8*y)", "(z + 1)^3/20", "0.5 + 0.5*tanh((x - z)/2)"}) {
    const Material material({formula});
    for (int i = 0; i < 10; ++i) {
      const Corners tet = tet_at(Vec3(1, 1, 1), 0.1, random);
      const double exact = corner_variation(material, tet);
      const TetCertificate found = certificate_of(material, tet, exact);
      EXPECT_EQ(found.proof, Proof::kProved) << formula;
      EXPECT_EQ(found.pieces, 1) << formula;
      EXPECT_NEAR(found.bound, exact, 1e-9 * exact) << formula;
    }
  }
}

TEST(TetCertificate, ProvesNoJump) {
  const Corners across{Vec3(7, 0, 0), Vec3(8, 0, 0), Vec3(7, 1, 0), Vec3(7, 0, 1)};
  const Material jump({"0.5*step(7.3, x) + x/50"});
  EXPECT_EQ(certificate_of(jump, across, 0.1).proof, Proof::kBroken);
  EXPECT_EQ(certificate_of(jump, across, 0.6).proof, Proof::kProved);
  const Material slit({"if(abs(x - 7.3) < 1e-9, 1, 0.2)"});
  EXPECT_NE(certificate_of(slit, across, 0.5).proof, Proof::kProved);
}

TEST(TetCertificate, CountsNothingWhereTheFractionIsNotDefined) {
  const Corners tet{Vec3(-0.01, 0, 0), Vec3(0.1, 0, 0), Vec3(0.01, 0.1, 0), Vec3(0.01, 0, 0.1)};
  const TetCertificate found = certificate_of(Material({"sqrt(x)"}), tet, 0.4);
  EXPECT_EQ(found.proof, Proof::kProved);
  EXPECT_GE(found.bound, std::sqrt(0.1) - 1e-12);
}

}  // namespace
}  // namespace fgmesh
