// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "field/cell_colours.hpp"
#include "field/energy.hpp"
#include "field/whole_sweep.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

using testing::colours_of;
using testing::RandomSamples;
using testing::whole_sweep;

/// Cells on a line of cubes, each joined to those up to `reach` away with a chance of a half.
Adjacency ribbon(std::uint32_t cells, std::uint32_t reach) {
  RandomSamples random(3);
  std::vector<WeightedEdge> edges;
  for (std::uint32_t i = 0; i < cells; ++i) {
    for (std::uint32_t j = i + 1; j <= i + reach && j < cells; ++j)
      if (random.uniform(0, 1) < 0.5) edges.push_back({i, j, 1});
  }
  return {cells, edges};
}

std::vector<std::size_t> block_of_cells(const SweepOrder& order, std::size_t phase, std::size_t cells) {
  std::vector<std::size_t> block_of(cells, SIZE_MAX);
  for (std::size_t block = order.phase_begin[phase]; block < order.phase_begin[phase + 1]; ++block) {
    for (std::size_t r = order.block_begin[block]; r < order.block_begin[block + 1]; ++r)
      for (const std::uint32_t cell : order.run(r)) block_of[cell] = block;
  }
  return block_of;
}

class SweepOrderTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  static constexpr std::uint32_t kCells = 3000;
  const Adjacency adjacency_ = ribbon(kCells, 12);
  const Colouring colouring_ = greedy_colouring(adjacency_);
  const std::vector<std::uint8_t> colours_ = colours_of(colouring_);

  /// By colours for a block size of 0.
  SweepOrder order() const {
    return GetParam() == 0 ? SweepOrder(colouring_)
                           : SweepOrder(adjacency_, colours_, GetParam(), whole_share(kCells));
  }
};

TEST_P(SweepOrderTest, VisitsEveryCellOnce) {
  std::vector<std::uint32_t> cells = order().cells;
  std::sort(cells.begin(), cells.end());
  ASSERT_EQ(cells.size(), kCells);
  for (std::uint32_t i = 0; i < kCells; ++i) ASSERT_EQ(cells[i], i);
  EXPECT_EQ(order().run_begin.back(), kCells);
}

TEST_P(SweepOrderTest, HasNoNeighboursInOneRun) {
  const SweepOrder order = this->order();
  for (std::size_t r = 0; r + 1 < order.run_begin.size(); ++r) {
    std::vector<bool> here(kCells);
    for (const std::uint32_t cell : order.run(r)) here[cell] = true;
    for (const std::uint32_t cell : order.run(r))
      for (const auto& [neighbour, weight] : adjacency_[cell]) ASSERT_FALSE(here[neighbour]);
  }
}

TEST_P(SweepOrderTest, HasNoNeighboursInTwoBlocksOfOnePhase) {
  const SweepOrder order = this->order();
  for (std::size_t phase = 0; phase < order.phase_count(); ++phase) {
    const auto block_of = block_of_cells(order, phase, kCells);
    for (std::uint32_t cell = 0; cell < kCells; ++cell) {
      if (block_of[cell] == SIZE_MAX) continue;
      for (const auto& [neighbour, weight] : adjacency_[cell])
        ASSERT_TRUE(block_of[neighbour] == SIZE_MAX || block_of[neighbour] == block_of[cell]);
    }
  }
}

TEST_P(SweepOrderTest, LetsASweepLowerTheEnergyByWhatItSays) {
  FieldGraph<4> graph{std::make_shared<const Connectivity>(Connectivity{adjacency_, order()}),
                      CellForms<4>(kCells)};
  FieldState<4> state = state_of<4>(random_frames(kCells, 4));
  const double before = graph_energy(graph, state);
  const double decrease = whole_sweep(graph, state, 1.4);
  EXPECT_GT(decrease, 0.1 * before);
  EXPECT_NEAR((before - graph_energy(graph, state)) / decrease, 1, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(BlockSizes, SweepOrderTest, ::testing::Values(0, 40, 256, 5000));

}  // namespace
}  // namespace crossgrain
