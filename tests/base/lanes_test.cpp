// SPDX-License-Identifier: Apache-2.0
#include "base/lanes.hpp"

#include <gtest/gtest.h>

#include "base/instruction_set.hpp"
#include "base/quaternion.hpp"

namespace crossgrain {
namespace {

/// Arithmetic of all kinds on a few numbers, in which any rounding differently would show.
template <class Real>
Real something_of(const Real& x) {
  using std::abs;
  using std::copysign;
  using std::sqrt;
  const BasicVector3<Real> v{0.1 * x, x - 0.3, 1 / (x + 2.5)};
  const auto axes = axes_of(normalised(from_small_rotation_vector(0.3 * orthogonal_unit(v))));
  const Real sum = dot(cross(axes[0], v), axes[1]) + norm(v) - copysign(sqrt(abs(x)), v[1]);
  return select(sum < 0.4, -sum, sum * x);
}

template <int W>
void expect_the_bits_of_doubles() {
  Lanes<W> x;
  for (int lane = 0; lane < W; ++lane) x.set(lane, 0.37 * lane - 0.81);
  const Lanes<W> result = something_of(x);
  for (int lane = 0; lane < W; ++lane) EXPECT_EQ(result[lane], something_of(x[lane])) << W << ", " << lane;
}

TEST(Lanes, GiveTheBitsThatDoublesGive) {
  expect_the_bits_of_doubles<2>();
  expect_the_bits_of_doubles<4>();
  expect_the_bits_of_doubles<8>();
}

TEST(Lanes, GiveTheSameBitsWithTheInstructionsOfThisProcessor) {
  int lanes = 0;
  run_in_lanes([&]<int W>() {
    expect_the_bits_of_doubles<W>();
    lanes = W;
  });
  EXPECT_GE(lanes, 2);
}

}  // namespace
}  // namespace crossgrain
