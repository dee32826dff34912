// SPDX-License-Identifier: Apache-2.0
#include "base/instruction_set.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace crossgrain {
namespace {

TEST(VectorWidth, IsNoMoreThanTheEnvironmentAllows) {
  // The first question settles the answer, so it is asked in a process of its own.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto lanes_with_two = [] {
    setenv("CROSSGRAIN_VECTOR_DOUBLES", "2", 1);
    int lanes = 0;
    run_in_lanes([&]<int W>() { lanes = W; });
    std::exit(lanes);
  };
  EXPECT_EXIT(lanes_with_two(), ::testing::ExitedWithCode(2), "");
}

}  // namespace
}  // namespace crossgrain
