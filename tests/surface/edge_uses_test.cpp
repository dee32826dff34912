// SPDX-License-Identifier: Apache-2.0
#include "surface/edge_uses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "crossgrain/thread_limit.hpp"

namespace crossgrain {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Use = std::tuple<std::uint64_t, std::uint32_t, bool>;

std::vector<Use> found(const Triangles& triangles) {
  std::vector<Use> uses;
  for (const EdgeUse& use : sorted_edge_uses(triangles))
    uses.emplace_back(use.edge, use.triangle, use.forward);
  return uses;
}

std::vector<Use> expected(const Triangles& triangles) {
  std::vector<Use> uses;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (a == b || b == c || c == a) continue;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      uses.emplace_back(std::uint64_t{std::min(from, to)} << 32 | std::max(from, to), t, from < to);
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

TEST(EdgeUses, AreThoseOfAllTrianglesThatAreNotCollapsed) {
  std::mt19937 random(1);
  for (const std::uint32_t vertices : {3u, 40u, 2000u, 100000u}) {
    Triangles triangles(100000);
    for (auto& triangle : triangles)
      for (std::uint32_t& v : triangle) v = static_cast<std::uint32_t>(random() % vertices);
    EXPECT_EQ(found(triangles), expected(triangles)) << vertices;
    const ThreadLimit one(1);
    EXPECT_EQ(found(triangles), expected(triangles)) << vertices;
  }
}

TEST(EdgeUses, OfFewTriangles) {
  EXPECT_TRUE(found({}).empty());
  EXPECT_TRUE(found({{7, 7, 9}}).empty());
  const Triangles two{{0, 1, UINT32_MAX}, {1, 0, 2}};
  EXPECT_EQ(found(two), expected(two));
}

}  // namespace
}  // namespace crossgrain
