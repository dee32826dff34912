// SPDX-License-Identifier: Apache-2.0
#include "singularity/frame_turn.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

#include "field/field_state.hpp"

namespace crossgrain {
namespace {

/// Frames that turn by so much of a full turn about an axis, in equal steps, but for the last, which leads
/// back to the first.
std::vector<Quaternion> way_of(const Quaternion& first, const Vector3& axis, double turns, int steps) {
  std::vector<Quaternion> way;
  for (int k = 0; k < steps; ++k)
    way.push_back(from_rotation_vector(2 * std::numbers::pi * turns * k / steps * axis) * first);
  return way;
}

CubeRotation product_along(const std::vector<Quaternion>& way) {
  CubeRotation product;
  for (std::size_t k = 0; k < way.size(); ++k)
    product = matching(way[k], way[(k + 1) % way.size()]) * product;
  return product;
}

Quaternion random_quaternion(std::mt19937& random) {
  return from_stored(random_frames(1, random())[0]);
}

struct Kind {
  Vector3 axis;  ///< of the frame's own
  double turns;
  FrameTurn::Kind kind;
};
const std::vector<Kind> kKinds{{{0, 1, 0}, 0.25, FrameTurn::Kind::kQuarter},
                               {{0, 1, 0}, 0.5, FrameTurn::Kind::kHalf},
                               {normalised(Vector3{1, -1, 1}), 1 / 3., FrameTurn::Kind::kThird},
                               {normalised(Vector3{1, 0, 1}), 0.5, FrameTurn::Kind::kSwap}};

TEST(FrameTurn, IsThatOfFramesThatTurnAboutAnAxisInSpace) {
  std::mt19937 random(3);
  for (const auto& [own_axis, turns, kind] : kKinds) {
    for (const double sign : {1., -1.}) {
      const Quaternion first = random_quaternion(random);
      const Vector3 axis = rotate(first, own_axis);
      const auto way = way_of(first, axis, sign * turns, 12);
      const FrameTurn turn = frame_turn(product_along(way), way);
      EXPECT_EQ(turn.kind, kind);
      EXPECT_NEAR(norm(turn.axis - sign * axis), 0, 1e-12);
    }
  }
}

TEST(FrameTurn, DoesNotDependOnTheNamesOfAxesNorOnTheFirstFrame) {
  std::mt19937 random(5);
  const CubeRotation renamings[] = {{1, 1, 0, 0}, {0, 1, 1, 0}, {1, -1, 1, 1}, {0, 0, 0, 1}};
  for (const auto& [own_axis, turns, kind] : kKinds) {
    const Quaternion first = random_quaternion(random);
    const Vector3 axis = rotate(first, own_axis);
    auto way = way_of(first, axis, turns, 12);
    std::rotate(way.begin(), way.begin() + 5, way.end());
    for (Quaternion& q : way) q = q * to_quaternion(renamings[random() % 4]);
    const FrameTurn turn = frame_turn(product_along(way), way);
    EXPECT_EQ(turn.kind, kind);
    EXPECT_NEAR(norm(turn.axis - axis), 0, 1e-12);
  }
}

TEST(FrameTurn, TheOtherWayAroundIsOpposite) {
  std::mt19937 random(7);
  for (const auto& [own_axis, turns, kind] : kKinds) {
    const Quaternion first = random_quaternion(random);
    auto way = way_of(first, rotate(first, own_axis), turns, 12);
    const FrameTurn turn = frame_turn(product_along(way), way);
    std::reverse(way.begin(), way.end());
    const FrameTurn back = frame_turn(product_along(way), way);
    EXPECT_EQ(back.kind, turn.kind);
    EXPECT_NEAR(norm(back.axis + turn.axis), 0, 1e-12);
  }
}

}  // namespace
}  // namespace crossgrain
