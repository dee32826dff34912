// SPDX-License-Identifier: Apache-2.0
#include "hex/untried_tets.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

HexAttempt tets(double size, std::size_t count, double edge) {
  HexAttempt attempt;
  attempt.tets = count;
  attempt.tet_size = size;
  attempt.tet_edge = edge;
  return attempt;
}

TEST(UntriedTets, AreBetweenTwoSizesThatMakeClearlyDifferentOnes) {
  EXPECT_NEAR(*untried_tet_size({tets(1.87, 21384, 0.65), tets(7.47, 9275, 0.9)}), 3.74, 1e-12);
  EXPECT_NEAR(*untried_tet_size({tets(8, 500, 4), tets(1, 9000, 1), tets(2, 3000, 2)}), 1.41, 1e-12);
}

TEST(UntriedTets, AreFinerThanTheEdgesThatDetailsAskForWhereAllSizesMakeTheSame) {
  // A cross of pipes: 31,269 tets with a median edge of 3.33 for any size from 4 to 22.
  const double size = *untried_tet_size({tets(5.6, 12000, 3.33)});
  EXPECT_NEAR(size, 0.75 * 3.33, 0.01);
}

TEST(UntriedTets, AreFinerWhereOnlyTheSizeLimitsThemToo) {
  EXPECT_NEAR(*untried_tet_size({tets(2, 12000, 2.16)}), 1.5, 1e-12);
}

TEST(UntriedTets, AreNoneWhereNoneAreKnownToBeOthersOrFinerOnesWouldBeTooMany) {
  EXPECT_FALSE(untried_tet_size({}));
  EXPECT_FALSE(untried_tet_size({HexAttempt()}));
  EXPECT_FALSE(untried_tet_size({tets(5.6, 31269, 3.33), tets(6, 30000, 3.4)}));
}

}  // namespace
}  // namespace crossgrain
