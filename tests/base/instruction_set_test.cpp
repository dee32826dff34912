// SPDX-License-Identifier: Apache-2.0
#include "base/instruction_set.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace crossgrain {
namespace {

TEST(VectorWidth, IsNoMoreThanTheEnvironmentAllows) {
  setenv("CROSSGRAIN_VECTOR_DOUBLES", "2", 1);  // before the first question, which settles the answer
  EXPECT_EQ(vector_width(), VectorWidth::kTwo);
  int lanes = 0;
  run_in_lanes([&]<int W>() { lanes = W; });
  EXPECT_EQ(lanes, 2);
}

}  // namespace
}  // namespace crossgrain
