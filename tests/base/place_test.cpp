// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/place.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

TEST(WordsOfAPlace, HaveFourDecimalsOfThePowerOfTenBelowTheSize) {
  EXPECT_EQ(words_of_place({106.12345, 51, 14.5}, 124), "106.12 51 14.5");
  EXPECT_EQ(words_of_place({0.501896, 0.079, 0.1}, 1.35), "0.5019 0.079 0.1");
  EXPECT_EQ(words_of_place({1e6 + 0.12347, 0, -2}, 1), "1000000.1235 0 -2");
  EXPECT_EQ(words_of_place({123456789, 0, 0}, 2e9), "123500000 0 0");
}

TEST(WordsOfAPlace, AreZeroWhereOnlyRoundingIsLeft) {
  EXPECT_EQ(words_of_place({-1.1e-15, 2, -0.0}, 10), "0 2 0");
  EXPECT_EQ(words_of_place({-1.1e-15, 2.41868e-18, -3e-17}, 1), "0 0 0");
  EXPECT_EQ(words_of_place({-1.1e-15, 2, 3}), "0 2 3");
  EXPECT_EQ(words_of_place({-1.1e-16, 0, -3e-17}), "0 0 0");
}

TEST(WordsOfAPlace, FollowTheLargestCoordinateWithoutASize) {
  EXPECT_EQ(words_of_place({30.032345, 34.5794, 76.2408}), "30.032 34.579 76.241");
  EXPECT_EQ(words_of_place({4, 5, 6}), "4 5 6");
}

}  // namespace
}  // namespace crossgrain
