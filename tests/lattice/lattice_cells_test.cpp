// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace crossgrain {
namespace {

LatticePlanes cube_planes(int cells) {
  LatticePlanes planes;
  for (auto& at : planes.at)
    for (int k = 0; k <= cells; ++k) at.push_back(k);
  return planes;
}

struct Box3 {
  std::size_t cells;
  std::vector<float> shares = std::vector<float>(cells * cells * cells, 0);
  float& at(std::size_t i, std::size_t j, std::size_t k) { return shares[(i * cells + j) * cells + k]; }
};

/// Number of sets of cells around a vertex with a value, connected by faces: by brute force.
int parts_around(const std::vector<bool>& filled, bool value) {
  int parts = 0;
  std::set<int> left;
  for (int q = 0; q < 8; ++q)
    if (filled[static_cast<std::size_t>(q)] == value) left.insert(q);
  while (!left.empty()) {
    ++parts;
    std::vector<int> open = {*left.begin()};
    left.erase(left.begin());
    while (!open.empty()) {
      const int q = open.back();
      open.pop_back();
      for (const int bit : {1, 2, 4})
        if (left.erase(q ^ bit) > 0) open.push_back(q ^ bit);
    }
  }
  return parts;
}

std::vector<Box> no_bodies() {
  return {};
}

TEST(LatticeCells, AreThoseWithHalfOfTheirVolumeInside) {
  Box3 box{6};
  for (std::size_t i = 1; i < 5; ++i)
    for (std::size_t j = 1; j < 5; ++j)
      for (std::size_t k = 1; k < 5; ++k) box.at(i, j, k) = i == 4 ? 0.49F : i == 1 ? 0.5F : 1;
  const KeptCells kept = kept_cells(box.shares, cube_planes(6), no_bodies);
  EXPECT_EQ(std::ranges::count(kept.is_kept, 1), 3 * 16);
  EXPECT_EQ(kept.toggled, 0u);
  EXPECT_EQ(kept.faults, 0u);
}

TEST(LatticeCells, TouchingInAnEdgeOrAVertexAreSeparatedOrJoined) {
  for (const bool in_edge : {true, false}) {
    Box3 box{8};
    const auto fill = [&](std::size_t i0, std::size_t j0, std::size_t k0) {
      for (std::size_t i = i0; i < i0 + 3; ++i)
        for (std::size_t j = j0; j < j0 + 3; ++j)
          for (std::size_t k = k0; k < k0 + 3; ++k) box.at(i, j, k) = 0.9F;
    };
    fill(1, 1, 1);
    fill(4, 4, in_edge ? 1 : 4);
    const KeptCells kept = kept_cells(box.shares, cube_planes(8), no_bodies);
    EXPECT_EQ(kept.faults, 0u);
    EXPECT_GT(kept.toggled, 0u);
  }
}

TEST(LatticeCells, AreManifoldWhateverTheShares) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> any(0, 1);
  constexpr std::size_t kCells = 12;
  for (int run = 0; run < 30; ++run) {
    Box3 box{kCells};
    for (std::size_t i = 1; i + 1 < kCells; ++i)
      for (std::size_t j = 1; j + 1 < kCells; ++j)
        for (std::size_t k = 1; k + 1 < kCells; ++k) box.at(i, j, k) = any(random);
    const KeptCells kept = kept_cells(box.shares, cube_planes(kCells), no_bodies);
    if (kept.faults > 0) continue;
    for (std::size_t i = 1; i < kCells; ++i)
      for (std::size_t j = 1; j < kCells; ++j)
        for (std::size_t k = 1; k < kCells; ++k) {
          std::vector<bool> filled;
          for (std::size_t q = 0; q < 8; ++q)
            filled.push_back(kept.is_kept[((i - 1 + (q & 1)) * kCells + j - 1 + (q >> 1 & 1)) * kCells + k -
                                          1 + (q >> 2)] != 0);
          ASSERT_LE(parts_around(filled, true), 1);
          ASSERT_LE(parts_around(filled, false), 1);
        }
  }
}

TEST(LatticeCells, AreNoCrumbs) {
  Box3 box{12};
  for (std::size_t i = 1; i < 8; ++i)
    for (std::size_t j = 1; j < 8; ++j)
      for (std::size_t k = 1; k < 8; ++k) box.at(i, j, k) = 1;
  box.at(10, 10, 10) = 0.6F;
  const KeptCells kept = kept_cells(box.shares, cube_planes(12), no_bodies);
  EXPECT_EQ(std::ranges::count(kept.is_kept, 1), 7 * 7 * 7);
  const auto body_around = [&](double low, double high) {
    const auto body = [=] { return std::vector{Box{{low, low, low}, {high, high, high}}}; };
    return std::ranges::count(kept_cells(box.shares, cube_planes(12), body).is_kept, 1);
  };
  const std::vector<double> at = cube_planes(12).at[0];
  EXPECT_EQ(body_around(at[10], at[11]), 7 * 7 * 7 + 1) << "a small body of the model";
  EXPECT_EQ(body_around(at[8], at[9]), 7 * 7 * 7) << "a crumb of another one";
}

}  // namespace
}  // namespace crossgrain
