// SPDX-License-Identifier: Apache-2.0
#include "base/digits.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

TEST(NumbersRoundedDown, AreNeverAboveTheLimitInTheirDigits) {
  EXPECT_EQ(rounded_down(2.38125, 2), 2.3);
  EXPECT_EQ(rounded_down(2.38125, 3), 2.38);
  EXPECT_EQ(rounded_down(0.0999, 1), 0.09);
  EXPECT_EQ(rounded_down(12345, 2), 12000);
}

TEST(NumbersRoundedDown, KeepALimitThatHasTheseDigits) {
  for (const double limit : {0.25, 0.3, 0.07, 1.0, 2.4, 35.0, 4100.0})
    EXPECT_EQ(rounded_down(limit, 2), limit);
}

TEST(ForecastCounts, HaveTwoDigits) {
  EXPECT_EQ(about(4123.4), "about 4100");
  EXPECT_EQ(about(12), "about 12");
  EXPECT_EQ(about(0.3), "about 1");
  EXPECT_EQ(about(2.345e6), "about 2.3 million");
  EXPECT_EQ(about(456e6), "about 460 million");
  EXPECT_EQ(about(4.56e9), "about 4.6 billion");
}

}  // namespace
}  // namespace crossgrain
