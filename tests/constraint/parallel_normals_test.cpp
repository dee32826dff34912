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

/// Up to eight normals within an angle of one, with random weights and signs.
Case random_case(RandomSamples& random, double angle) {
  const Vector3 first = random.direction();
  Case made{ParallelNormals(first), {}};
  const int count = random.integer(3, 8);
  for (int k = 0; k < count; ++k) {
    const double weight = random.uniform(0.1, 1);
    Vector3 normal = first;
    if (k > 0) {
      const Vector3 across = normalised(cross(first, random.direction()));
      const double turn = angle * std::sqrt(random.uniform(0, 1));
      normal = std::cos(turn) * first + std::sin(turn) * across;
    }
    if (random.uniform(0, 1) < 0.5) normal = -normal;
    made.normals.add(normal, weight);
    add_normal(made.form, normal, weight);
  }
  return made;
}

/// The largest share by which the frame of the formula exceeds the least value.
double largest_excess(double angle) {
  RandomSamples random(5);
  double largest = 0;
  for (int k = 0; k < 500; ++k) {
    const Case made = random_case(random, angle);
    const auto frame = made.normals.best_frame();
    if (!frame) return INFINITY;
    const double least = least_value(made.form, *frame);
    const double found = value(made.form, frame_coefficients<4>(*frame));
    EXPECT_GE(found, least - 1e-14 * made.form.weight);
    largest = std::max(largest, (found - least) / least);
  }
  return largest;
}

TEST(ParallelNormals, HaveTheBestFrameToTwiceTheFourthPowerOfTheirAngle) {
  for (const double angle : {0.0999, 0.05, 0.025}) {
    EXPECT_LT(largest_excess(angle), 2 * std::pow(angle, 4)) << angle;
    EXPECT_GT(largest_excess(angle), 0.5 * std::pow(angle, 4)) << angle;
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
