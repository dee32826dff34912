// SPDX-License-Identifier: Apache-2.0
#include "harmonics/frame.hpp"

#include "harmonics/generators.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

template <class Degree>
class FrameCoefficients : public ::testing::Test {};
TYPED_TEST_SUITE(FrameCoefficients, testing::BothDegrees);

TYPED_TEST(FrameCoefficients, OfTheIdentityAreTheReferenceFrame) {
  constexpr int D = TypeParam::value;
  EXPECT_LT(testing::largest_difference(frame_coefficients<D>(Quaternion{}), reference_frame<D>()), 1e-15);
}

TYPED_TEST(FrameCoefficients, AreOfUnitNorm) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(squared_norm(frame_coefficients<D>(random.rotation())), 1, 1e-14);
}

TYPED_TEST(FrameCoefficients, StayTheSameWhenAxesAreNamedOtherwise) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  const Quaternion q = random.rotation();
  const Coefficients<D> h = frame_coefficients<D>(q);
  const double half = std::sqrt(0.5);
  for (const Quaternion& quarter : {Quaternion{half, half, 0, 0}, {half, 0, half, 0}, {half, 0, 0, half}}) {
    // A quarter turn flips the sign of x y z, which in degree 3 is the same frame.
    const Coefficients<D> expected = scaled(h, D == 3 ? -1 : 1);
    EXPECT_LT(testing::largest_difference(frame_coefficients<D>(q * quarter), expected), 1e-14);
  }
}

TYPED_TEST(FrameCoefficients, TellFramesApart) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  for (int i = 0; i < 100; ++i) {
    const Quaternion p = random.rotation(), q = random.rotation();
    const double overlap = dot(frame_coefficients<D>(p), frame_coefficients<D>(q));
    const double angle = testing::misorientation_rad(p, q);
    // 1 - |overlap| grows at least as angle^2 / 2 up to the largest misorientation, 62.8 degrees.
    EXPECT_LT(D == 3 ? std::fabs(overlap) : overlap, 1 - angle * angle / 2);
  }
}

TEST(FrameCoefficientsOfDegreeFour, CostTenThirdsOfTheSquaredAnglePerUnitWeight) {
  // |L_a h~|^2 = 20/3 for every axis: half of the squared difference is (10/3) t^2.
  for (const auto& lh : apply_generators<4>(reference_frame<4>()))
    EXPECT_NEAR(squared_norm(lh), 20.0 / 3, 1e-14);
}

TEST(FrameCoefficientsOfDegreeThree, TurnByThreeFifthsOfThat) {
  for (const auto& lh : apply_generators<3>(reference_frame<3>())) EXPECT_NEAR(squared_norm(lh), 4, 1e-14);
}

}  // namespace
}  // namespace crossgrain
