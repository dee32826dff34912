// SPDX-License-Identifier: Apache-2.0
#include "singularity/matching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace crossgrain {
namespace {

constexpr CubeRotation kQuarterAboutX{1, 1, 0, 0};
constexpr CubeRotation kQuarterAboutZ{1, 0, 0, 1};

class RandomRotations {
 public:
  explicit RandomRotations(unsigned seed) : engine_(seed) {}
  Quaternion next() {
    return normalised(Quaternion{normal_(engine_), normal_(engine_), normal_(engine_), normal_(engine_)});
  }

 private:
  std::mt19937 engine_;
  std::normal_distribution<double> normal_;
};

/// All that two quarter turns generate.
std::vector<CubeRotation> generated_group() {
  std::vector<CubeRotation> group{CubeRotation{}};
  for (std::size_t k = 0; k < group.size(); ++k) {
    for (const CubeRotation& generator : {kQuarterAboutX, kQuarterAboutZ}) {
      const CubeRotation product = generator * group[k];
      if (std::find(group.begin(), group.end(), product) == group.end()) group.push_back(product);
    }
  }
  return group;
}

/// |p . q|: 1 for the same rotation, less the farther apart two rotations are.
double closeness(const Quaternion& p, const Quaternion& q) {
  return std::abs(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z);
}

TEST(CubeRotation, TwoQuarterTurnsGenerateTwentyFour) {
  EXPECT_EQ(generated_group().size(), 24u);
}

TEST(CubeRotation, MapsTheAxesToAxes) {
  for (const CubeRotation& g : generated_group()) {
    for (const Vector3& axis : axes_of(to_quaternion(g))) {
      EXPECT_NEAR(std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])}), 1, 1e-15);
    }
  }
}

TEST(CubeRotation, ProductsAreThoseOfTheRotations) {
  const auto group = generated_group();
  for (const CubeRotation& a : group) {
    for (const CubeRotation& b : group) {
      EXPECT_NEAR(closeness(to_quaternion(a * b), to_quaternion(a) * to_quaternion(b)), 1, 1e-15);
    }
  }
}

TEST(CubeRotation, TimesItsInverseIsTheIdentity) {
  for (const CubeRotation& g : generated_group()) {
    EXPECT_TRUE((g * inverse(g)).is_identity());
    EXPECT_TRUE((inverse(g) * g).is_identity());
  }
}

TEST(CubeRotation, IsOddWhereTwoAxesChangePlaces) {
  int odd = 0;
  for (const CubeRotation& g : generated_group()) {
    int in_place = 0;
    const auto axes = axes_of(to_quaternion(g));
    for (std::size_t k = 0; k < 3; ++k) in_place += std::abs(axes[k][k]) > 0.5;
    EXPECT_EQ(g.is_odd(), in_place == 1);
    odd += g.is_odd();
  }
  EXPECT_EQ(odd, 12);
}

TEST(NearestCubeRotation, IsTheNearestOfAllTwentyFour) {
  const auto group = generated_group();
  RandomRotations random(1);
  for (int sample = 0; sample < 2000; ++sample) {
    const Quaternion q = random.next();
    const auto nearest =
        std::max_element(group.begin(), group.end(), [&](const CubeRotation& a, const CubeRotation& b) {
          return closeness(q, to_quaternion(a)) < closeness(q, to_quaternion(b));
        });
    EXPECT_EQ(nearest_cube_rotation(q), *nearest);
  }
}

TEST(NearestCubeRotation, OfACubeRotationIsItself) {
  for (const CubeRotation& g : generated_group()) EXPECT_EQ(nearest_cube_rotation(to_quaternion(g)), g);
}

TEST(Matching, FindsHowTheNeighboursAxesAreNamed) {
  RandomRotations random(2);
  const Quaternion turn = from_rotation_vector({0.2, -0.3, 0.1});  // well below 45 degrees
  for (const CubeRotation& g : generated_group()) {
    const Quaternion to = random.next();
    const Quaternion from = turn * to * to_quaternion(g);
    EXPECT_EQ(matching(to_stored(from), to_stored(to)), g);
  }
}

TEST(Matching, AlongAWayComposesToTheRenamingBetweenItsEnds) {
  const auto group = generated_group();
  const Quaternion frame = from_rotation_vector({0.4, 0.5, -0.6});
  const auto named = [&](const CubeRotation& g) { return to_stored(frame * to_quaternion(g)); };
  for (std::size_t k = 0; k < group.size(); ++k) {
    const StoredQuaternion first = named(group[k]), second = named(group[(k + 5) % 24]),
                           third = named(group[(k + 11) % 24]);
    EXPECT_EQ(matching(second, third) * matching(first, second), matching(first, third));
  }
}

TEST(Matching, BackIsTheInverse) {
  RandomRotations random(3);
  for (int sample = 0; sample < 500; ++sample) {
    const StoredQuaternion a = to_stored(random.next()), b = to_stored(random.next());
    EXPECT_EQ(matching(b, a), inverse(matching(a, b)));
  }
}

}  // namespace
}  // namespace crossgrain
