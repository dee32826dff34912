// SPDX-License-Identifier: Apache-2.0
// The spectra that docs/method.md draws, against the exact numbers of docs/design.md section 3.
#include "shape_spectra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crossgrain::figures {
namespace {

void expect_eigenvalues(const ShapeSpectrum& found, Coefficients<3> expected, double divisor = 1) {
  std::sort(expected.begin(), expected.end());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(found.eigenvalues[i], expected[i] / divisor, 1e-12) << "eigenvalue " << i;
}

TEST(ShapeSpectra, OfAPlaneLeaveTwoOfSevenOpen) {
  expect_eigenvalues(plane_spectrum(), {0, 0, 1, 1, 1, 1, 1});
  EXPECT_STREQ(name_of(plane_spectrum().constraint_class), "plane");
}

TEST(ShapeSpectra, OfTheCornerOfACubeLeaveTheCubeOpen) {
  expect_eigenvalues(corner_spectrum(), {0, 2, 2, 2, 3, 3, 3}, 3);
  EXPECT_STREQ(name_of(corner_spectrum().constraint_class), "frame");
}

TEST(ShapeSpectra, OfACylinderLeaveItsAxisOpenAsACompromise) {
  expect_eigenvalues(cylinder_spectrum(), {8, 8, 11, 11, 13, 13, 16}, 16);
  EXPECT_STREQ(name_of(cylinder_spectrum().constraint_class), "axis");
}

TEST(ShapeSpectra, OfASphereAreSevenTimesTheSame) {
  expect_eigenvalues(sphere_spectrum(), {5, 5, 5, 5, 5, 5, 5}, 7);
  EXPECT_STREQ(name_of(sphere_spectrum().constraint_class), "free");
}

// The two projectors have one harmonic each that is odd and one that is even along the crease. These meet
// their like at cosines cos 2a and (5 cos a + 3 cos 3a) / 8, and each pair of lines at cosine c leaves the
// eigenvalues (1 - c) / 2 and (1 + c) / 2.
TEST(ShapeSpectra, OfACreaseFollowTheirFormulaAtEveryAngle) {
  for (int angle_deg = 0; angle_deg <= 180; ++angle_deg) {
    SCOPED_TRACE(angle_deg);
    const double a = angle_deg * std::numbers::pi / 180, sine = std::sin(a), cosine = std::cos(a);
    const double g = (5 * cosine + 3 * std::cos(3 * a)) / 8;
    expect_eigenvalues(crease_spectrum(angle_deg),
                       {sine * sine, cosine * cosine, (1 - g) / 2, (1 + g) / 2, 1, 1, 1});
  }
}

TEST(ShapeSpectra, OfCreasesHaveTheClassesThatThePageNames) {
  EXPECT_STREQ(name_of(crease_spectrum(20).constraint_class), "plane");
  EXPECT_STREQ(name_of(crease_spectrum(30).constraint_class), "axis");
  EXPECT_STREQ(name_of(crease_spectrum(45).constraint_class), "conflicted");
  EXPECT_STREQ(name_of(crease_spectrum(60).constraint_class), "frame, compromised");
  EXPECT_STREQ(name_of(crease_spectrum(90).constraint_class), "frame");
}

}  // namespace
}  // namespace crossgrain::figures
