// SPDX-License-Identifier: Apache-2.0
#include "base/first_equal.hpp"

#include <gtest/gtest.h>

#include "crossgrain/thread_limit.hpp"

namespace crossgrain {
namespace {

using Key = std::array<std::uint32_t, 3>;

/// Keys in no order, of which `distinct` are different.
Key key_of(std::size_t i, std::uint32_t distinct) {
  const auto number = static_cast<std::uint32_t>(i * 2654435761u % distinct);
  return {number, 7, number * 3};
}

/// By a table with a place for every key that there can be.
std::vector<std::uint32_t> expected(std::size_t count, std::uint32_t distinct) {
  std::vector<std::uint32_t> seen(distinct, UINT32_MAX), first(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t& known = seen[key_of(i, distinct)[0]];
    if (known == UINT32_MAX) known = static_cast<std::uint32_t>(i);
    first[i] = known;
  }
  return first;
}

std::vector<std::uint32_t> found(std::size_t count, std::uint32_t distinct) {
  std::vector<std::uint32_t> first(count, 12345);
  find_first_equal([&](std::size_t i) { return key_of(i, distinct); }, first);
  return first;
}

TEST(FirstEqual, FindsTheFirstOfEqualKeysHoweverManyThereAre) {
  for (const std::size_t count : {0u, 1u, 2u, 1000u, 70'000u}) {
    for (const std::uint32_t distinct : {1u, 2u, 500u, 100'000u})
      EXPECT_EQ(found(count, distinct), expected(count, distinct)) << count << " " << distinct;
  }
}

TEST(FirstEqual, IsRightOverSeveralRoundsAndTheSameForAnyNumberOfThreads) {
  constexpr std::size_t kCount = 4'500'000;
  for (const std::uint32_t distinct : {800'000u, 1u}) {
    const std::vector<std::uint32_t> reference = expected(kCount, distinct);
    for (const int threads : {1, 2}) {
      const ThreadLimit limit(threads);
      EXPECT_TRUE(found(kCount, distinct) == reference) << distinct << " " << threads;
    }
  }
}

TEST(RankedSet, CountsTheMembersBelow) {
  const RankedSet odd(1000, [](std::size_t i) { return i % 2 == 1; });
  EXPECT_EQ(odd.size(), 500u);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(odd.rank(i), i / 2);
    EXPECT_EQ(odd.contains(i), i % 2 == 1);
  }
  EXPECT_EQ(RankedSet(0, [](std::size_t) { return true; }).size(), 0u);
}

}  // namespace
}  // namespace crossgrain
