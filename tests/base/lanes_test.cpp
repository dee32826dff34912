// SPDX-License-Identifier: Apache-2.0
#include "base/lanes.hpp"

#include <gtest/gtest.h>

#include "base/instruction_set.hpp"
#include "base/lane_rows.hpp"
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

template <class Real>
void expect_pairwise_sums() {
  constexpr int W = Real::kCount;
  std::array<Real, W> x;
  for (int k = 0; k < W; ++k) {
    for (int lane = 0; lane < W; ++lane) x[k].set(lane, 100 * k + lane);
  }
  const Real sums = sums_over_lanes(x);
  for (int k = 0; k < W; ++k) EXPECT_EQ(sums[k], W * 100 * k + W * (W - 1) / 2) << W;
}

/// Rows of six numbers, in an order of their own, of which the middle four are used.
template <class Real>
void expect_rows_there_and_back() {
  constexpr int W = Real::kCount;
  std::array<std::array<float, 6>, W> rows;
  for (int row = 0; row < W; ++row) {
    for (int k = 0; k < 6; ++k) rows[row][k] = static_cast<float>(10 * row + k);
  }
  const auto row_of = [](int lane) { return (lane * 7 + 3) % W; };
  FourOfRows<Real> x = four_from_rows<Real>([&](int lane) { return rows[row_of(lane)].data() + 1; });
  for (int lane = 0; lane < W; ++lane) {
    for (int k = 0; k < 4; ++k) EXPECT_EQ(x[k][lane], 10 * row_of(lane) + k + 1) << W << ", " << lane;
  }
  for (Real& numbers : x) numbers *= -1.0;
  // Every third lane stays behind.
  four_to_rows<Real>(x, [&](int lane) { return lane % 3 == 0 ? nullptr : rows[row_of(lane)].data() + 1; });
  for (int lane = 0; lane < W; ++lane) {
    const int row = row_of(lane);
    for (int k = 0; k < 6; ++k) {
      const bool is_written = lane % 3 != 0 && k >= 1 && k <= 4;
      EXPECT_EQ(rows[row][k], (is_written ? -1 : 1) * (10 * row + k)) << W << ", " << lane;
    }
  }
}

template <class Real>
class LanesOfAKind : public ::testing::Test {};
using AllLanes =
    ::testing::Types<Lanes<2>, Lanes<4>, Lanes<8>, SingleLanes<4>, SingleLanes<8>, SingleLanes<16>>;
TYPED_TEST_SUITE(LanesOfAKind, AllLanes);

TYPED_TEST(LanesOfAKind, AreSummedEachVectorInItsOwnLane) {
  expect_pairwise_sums<TypeParam>();
}

TYPED_TEST(LanesOfAKind, TakeRowsAndGiveThemBack) {
  expect_rows_there_and_back<TypeParam>();
}

}  // namespace
}  // namespace crossgrain
