// SPDX-License-Identifier: Apache-2.0
#include "constraint/parallel_normals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "constraint/normal_form.hpp"
#include "constraint/spectral_shift.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

struct Case {
  ParallelNormals normals;
  QuadraticForm<4> form;
};

enum class Spread { kToAllSides, kInAPlane };

/// Up to eight normals within an angle of one, with random weights and signs; in a plane with weights of
/// several orders of magnitude, which is the worst.
Case random_case(RandomSamples& random, Spread spread, double angle) {
  const Vector3 first = random.direction(), plane = random.direction();
  Case made{ParallelNormals(first), {}};
  const int count = random.integer(3, 8);
  for (int k = 0; k < count; ++k) {
    const double weight =
        spread == Spread::kInAPlane ? std::pow(10, random.uniform(-3, 0)) : random.uniform(0.1, 1);
    Vector3 normal = first;
    if (k > 0) {
      const Vector3 across =
          normalised(cross(first, spread == Spread::kInAPlane ? plane : random.direction()));
      const double sense = spread == Spread::kInAPlane && random.uniform(0, 1) < 0.5 ? -1 : 1;
      const double turn = sense * angle * std::sqrt(random.uniform(0, 1));
      normal = std::cos(turn) * first + std::sin(turn) * across;
    }
    if (random.uniform(0, 1) < 0.5) normal = -normal;
    made.normals.add(normal, weight);
    add_normal(made.form, normal, weight);
  }
  return made;
}

/// The largest share by which the frame of the formula exceeds the least value.
double largest_excess(Spread spread, double angle) {
  RandomSamples random(5);
  double largest = 0;
  for (int k = 0; k < 500; ++k) {
    const Case made = random_case(random, spread, angle);
    const auto frame = made.normals.best_frame();
    if (!frame) return INFINITY;
    const double least = least_value(made.form, *frame);
    const double found = value(made.form, frame_coefficients<4>(*frame));
    EXPECT_GE(found, least - 1e-14 * made.form.weight);
    largest = std::max(largest, (found - least) / least);
  }
  return largest;
}

TEST(ParallelNormals, HaveTheBestFrameToAFewTimesTheFourthPowerOfTheirAngle) {
  for (const auto& [spread, times] :
       {std::pair(Spread::kToAllSides, 2.5), std::pair(Spread::kInAPlane, 7.0)}) {
    for (const double angle : {0.0999, 0.05, 0.025}) {
      EXPECT_LT(largest_excess(spread, angle), times * std::pow(angle, 4)) << angle;
      EXPECT_GT(largest_excess(spread, angle), times / 4 * std::pow(angle, 4)) << angle;
    }
  }
}

TEST(ParallelNormals, AreAtMostATenthOfARadianApart) {
  ParallelNormals normals({0, 0, 1});
  for (const double angle : {0.0, 0.0999, 0.101}) {
    normals.add({-std::sin(angle), 0, -std::cos(angle)}, 1);
    EXPECT_EQ(normals.best_frame().has_value(), angle < 0.1);
  }
}

TEST(ParallelNormals, ThatAreOneGiveAFrameWithThatAxis) {
  const Vector3 axis = normalised(Vector3{1, 2, -3});
  ParallelNormals normals(axis);
  normals.add(-axis, 2);
  EXPECT_NEAR(normal_value<4>(normal_basis<4>(axis), frame_coefficients<4>(*normals.best_frame())), 0, 1e-15);
}

}  // namespace
}  // namespace crossgrain
