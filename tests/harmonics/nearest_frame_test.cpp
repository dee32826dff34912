// SPDX-License-Identifier: Apache-2.0
#include "harmonics/frame.hpp"
#include "harmonics/frame_cover.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

template <int D>
double score(const Coefficients<D>& target, const Quaternion& frame) {
  const double overlap = dot(target, frame_coefficients<D>(frame));
  return D == 3 ? std::fabs(overlap) : overlap;
}

// Coefficients of 20000 random frames: some is within 3 degrees or so of any frame.
template <int D>
const std::vector<Coefficients<D>>& dense_sample() {
  static const std::vector<Coefficients<D>> sample = [] {
    testing::RandomSamples random(99);
    std::vector<Coefficients<D>> frames;
    for (int i = 0; i < 20000; ++i) frames.push_back(frame_coefficients<D>(random.rotation()));
    return frames;
  }();
  return sample;
}

template <int D>
double best_of_sample(const Coefficients<D>& target) {
  double best = -INFINITY;
  for (const auto& h : dense_sample<D>()) {
    const double overlap = dot(target, h);
    best = std::max(best, D == 3 ? std::fabs(overlap) : overlap);
  }
  return best;
}

template <class Degree>
class NearestFrame : public ::testing::Test {};
TYPED_TEST_SUITE(NearestFrame, testing::BothDegrees);

TYPED_TEST(NearestFrame, OfAFrameIsThatFrame) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(1);
  for (int i = 0; i < 200; ++i) {
    const Quaternion q = random.rotation();
    const Quaternion found = nearest_frame<D>(scaled(frame_coefficients<D>(q), random.uniform(0.01, 100)));
    // acos near 1 keeps half the digits.
    EXPECT_LT(testing::misorientation_rad(found, q), 1e-7);
  }
}

TYPED_TEST(NearestFrame, OfRandomCoefficientsIsNotBeatenByDenseSampling) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(2);
  for (int i = 0; i < 2000; ++i) {
    const auto target = random.coefficients<D>();
    EXPECT_GE(score<D>(target, nearest_frame<D>(target)), best_of_sample<D>(target));
  }
}

TYPED_TEST(NearestFrame, OfSumsOfFramesIsNotBeatenByDenseSampling) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(3);
  for (int i = 0; i < 500; ++i) {
    Coefficients<D> target{};
    for (int k = 0; k < 2 + i % 3; ++k) add_scaled(target, 1, frame_coefficients<D>(random.rotation()));
    EXPECT_GE(score<D>(target, nearest_frame<D>(target)), best_of_sample<D>(target));
  }
}

TYPED_TEST(NearestFrame, OfEachSingleHarmonicAndItsNegativeIsNotBeatenByDenseSampling) {
  constexpr int D = TypeParam::value;
  for (int i = 0; i < kCoefficientCount<D>; ++i) {
    for (const double sign : {1.0, -1.0}) {
      Coefficients<D> target{};
      target[i] = sign;
      // Whole circles of frames can be equally near here, so the last digits of a score are rounding.
      EXPECT_GE(score<D>(target, nearest_frame<D>(target)), best_of_sample<D>(target) - 1e-12)
          << i << " " << sign;
    }
  }
}

TYPED_TEST(NearestFrame, TurnsWithItsTarget) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(4);
  for (int i = 0; i < 100; ++i) {
    const Quaternion p = random.rotation(), q = random.rotation(), turn = random.rotation();
    Coefficients<D> target{}, turned{};
    for (const auto& [frame, weight] : {std::pair{p, 2.0}, std::pair{q, 1.0}}) {
      // Degree 3 has no sign to add with: take the one that makes the two frames agree.
      const bool flipped = D == 3 && dot(frame_coefficients<D>(p), frame_coefficients<D>(frame)) < 0;
      const bool turned_flipped =
          D == 3 && dot(frame_coefficients<D>(turn * p), frame_coefficients<D>(turn * frame)) < 0;
      add_scaled(target, flipped ? -weight : weight, frame_coefficients<D>(frame));
      add_scaled(turned, turned_flipped ? -weight : weight, frame_coefficients<D>(turn * frame));
    }
    EXPECT_LT(testing::misorientation_rad(nearest_frame<D>(turned), turn * nearest_frame<D>(target)), 1e-6);
  }
}

TYPED_TEST(NearestFrame, DoesNotDependOnTheTargetsScale) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(5);
  const auto target = random.coefficients<D>();
  for (const double factor : {1e-150, 1e-20, 1e20, 1e150}) {
    EXPECT_NEAR(score<D>(target, nearest_frame<D>(scaled(target, factor))),
                score<D>(target, nearest_frame<D>(target)), 1e-12);
  }
}

TYPED_TEST(NearestFrame, OfNothingIsTheIdentity) {
  constexpr int D = TypeParam::value;
  const Quaternion q = nearest_frame<D>(Coefficients<D>{});
  EXPECT_EQ(q.w, 1);
  EXPECT_EQ(q.x, 0);
}

TYPED_TEST(NearestFrame, RefinedFromNearbyIsTheLocalOne) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(6);
  for (int i = 0; i < 100; ++i) {
    const Quaternion q = random.rotation();
    const Quaternion start = from_rotation_vector(0.2 * random.direction()) * q;
    EXPECT_LT(testing::misorientation_rad(refine_frame<D>(frame_coefficients<D>(q), start), q), 1e-7);
  }
}

TYPED_TEST(NearestFrame, StartsFromACoverWithoutHoles) {
  constexpr int D = TypeParam::value;
  testing::RandomSamples random(7);
  for (int i = 0; i < 2000; ++i) {
    const Quaternion q = random.rotation();
    double nearest = INFINITY;
    for (const auto& member : frame_cover<D>()) {
      nearest = std::min(nearest, testing::misorientation_rad(member.rotation, q));
    }
    EXPECT_LT(nearest, 19 * 3.14159265 / 180);
  }
}

TEST(NearestFrameOfDegreeThree, IsTheSameForTheNegativeTarget) {
  testing::RandomSamples random(8);
  const auto target = random.coefficients<3>();
  EXPECT_LT(testing::misorientation_rad(nearest_frame<3>(target), nearest_frame<3>(scaled(target, -1))),
            1e-7);
}

}  // namespace
}  // namespace crossgrain
