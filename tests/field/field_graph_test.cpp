// SPDX-License-Identifier: Apache-2.0
#include "field/field_graph.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "constraint/normal_form.hpp"
#include "crossgrain/error.hpp"
#include "field/field_state.hpp"
#include "field/small_solve.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::RandomSamples;

TEST(Adjacency, HoldsEachEdgeInBothItsCells) {
  RandomSamples random(1);
  std::vector<WeightedEdge> edges;
  std::map<std::pair<std::uint32_t, std::uint32_t>, float> weights;
  for (std::uint32_t i = 0; i < 50; ++i) {
    for (std::uint32_t j = i + 1; j < 50; ++j) {
      if (random.uniform(0, 1) > 0.1) continue;
      edges.push_back({i, j, static_cast<float>(random.uniform(0, 1))});
      weights[{i, j}] = weights[{j, i}] = edges.back().weight;
    }
  }
  const Adjacency adjacency(50, edges);
  ASSERT_EQ(adjacency.size(), 50u);
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < 50; ++i) {
    for (const auto& [j, weight] : adjacency[i]) {
      EXPECT_EQ(weights.at({i, j}), weight);
      ++count;
    }
  }
  EXPECT_EQ(count, weights.size());
}

TEST(Adjacency, KeepsTheOrderOfTheEdges) {
  const std::vector<WeightedEdge> edges{{2, 0, 1}, {0, 3, 2}, {1, 0, 3}};
  const Adjacency adjacency(4, edges);
  ASSERT_EQ(adjacency[0].size(), 3u);
  EXPECT_EQ(adjacency[0][0].cell, 2u);
  EXPECT_EQ(adjacency[0][1].cell, 3u);
  EXPECT_EQ(adjacency[0][2].cell, 1u);
}

TEST(Adjacency, HoldsTheRowsItIsMadeOfWhetherTheyShareWeightsOrNot) {
  constexpr std::uint32_t kCells = 1000;  // several chunks of the parallel loop
  const auto row_of = [](std::size_t i, std::vector<Adjacency::Neighbour>& row) {
    // A few kinds of rows, so that most share their weights, and some of their own in between.
    for (std::uint32_t k = 0; k < i % 5; ++k)
      row.push_back({static_cast<std::uint32_t>((i + k + 1) % kCells), i % 7 == 0 ? 0.5f + i : 0.25f + k});
  };
  const Adjacency adjacency(kCells, row_of);
  ASSERT_EQ(adjacency.size(), kCells);
  for (std::size_t i = 0; i < kCells; ++i) {
    std::vector<Adjacency::Neighbour> expected;
    row_of(i, expected);
    ASSERT_EQ(adjacency[i].size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_EQ(adjacency[i][k].cell, expected[k].cell);
      EXPECT_EQ(adjacency[i][k].weight, expected[k].weight);
    }
  }
}

TEST(Adjacency, HoldsWeightsAsMultiplesOfUnitsToo) {
  constexpr std::uint32_t kCells = 3000;  // several groups
  const std::vector<float> units{0.5f, 0.3f};
  const auto row_of = [](std::size_t i, Adjacency::RowInUnits& row) {
    row.unit = i % 3 == 0;
    for (std::uint32_t k = 0; k < i % 23; ++k)
      row.neighbours.push_back({static_cast<std::uint32_t>((7 * i + 131 * k + 1) % kCells),
                                static_cast<std::uint16_t>(i % 7 == 0 ? 30720 : 5 * k + 1)});
  };
  const Adjacency adjacency(kCells, units, row_of);
  ASSERT_EQ(adjacency.size(), kCells);
  for (std::size_t i = 0; i < kCells; ++i) {
    Adjacency::RowInUnits expected;
    row_of(i, expected);
    const Adjacency::Row row = adjacency[i];
    ASSERT_EQ(row.size(), expected.neighbours.size());
    ASSERT_EQ(row.has_equal_weights(), row.size() == 1 || (i % 7 == 0 && !row.empty()));
    for (std::size_t k = 0; k < row.size(); ++k) {
      EXPECT_EQ(row[k].cell, expected.neighbours[k].cell);
      EXPECT_EQ(row[k].weight, units[expected.unit] * expected.neighbours[k].units);
    }
    if (row.has_equal_weights()) continue;
    const auto first = row.weights_from<SingleLanes<4>>(0);
    for (int lane = 0; lane < 4 && static_cast<std::size_t>(lane) < row.size(); ++lane)
      EXPECT_EQ(first[lane], row.weight(static_cast<std::size_t>(lane)));
  }
}

TEST(Adjacency, TakesFewBytesForALeafWithEighteenNeighboursOfOwnWeights) {
  constexpr std::uint32_t kCells = 20000;
  const Adjacency adjacency(kCells, {1.0f}, [](std::size_t i, Adjacency::RowInUnits& row) {
    for (std::uint32_t k = 0; k < 18; ++k)
      row.neighbours.push_back(
          {static_cast<std::uint32_t>((i + 37 * k + 1) % kCells), static_cast<std::uint16_t>(k + 1)});
  });
  EXPECT_LT(adjacency.bytes(), 90 * kCells);
}

TEST(Adjacency, OfCellsWithoutEdgesIsEmptyRows) {
  const Adjacency adjacency(3, std::vector<WeightedEdge>{});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(adjacency[i].empty());
  EXPECT_EQ(Adjacency().size(), 0u);
}

TEST(Colouring, VisitsEveryCellOnceColourByColour) {
  const std::vector<std::uint8_t> colours{2, 0, 2, 3, 0};
  const Colouring colouring = colouring_of(colours);
  ASSERT_EQ(colouring.colour_count(), 4u);
  EXPECT_EQ(colouring.cells, (std::vector<std::uint32_t>{1, 4, 0, 2, 3}));
  EXPECT_EQ(colouring.begin, (std::vector<std::size_t>{0, 2, 2, 4, 5}));
}

TEST(Colouring, OfNoCellsHasNoColours) {
  EXPECT_EQ(colouring_of({}).colour_count(), 0u);
}

template <class Degree>
class SmallGraphTest : public ::testing::Test {};
TYPED_TEST_SUITE(SmallGraphTest, BothDegrees);

TYPED_TEST(SmallGraphTest, FormsAreFoundWhereTheyWereSet) {
  constexpr int D = TypeParam::value;
  CellForms<D> forms(5);
  forms.set_plane(3, {0, 0, 1}, 2);
  const std::vector<std::uint32_t> general{1, 4};
  forms.reserve_general(general);
  const QuadraticForm<D> form = normal_form<D>({1, 0, 0});
  forms.set_general(4, form, 0.5);
  forms.set_general(1, form, 1);
  for (const std::size_t cell : {0, 2}) {
    EXPECT_TRUE(forms.empty(cell));
    EXPECT_EQ(forms.plane(cell), nullptr);
    EXPECT_EQ(forms.general(cell), nullptr);
  }
  EXPECT_EQ(forms.general(3), nullptr);
  ASSERT_NE(forms.plane(3), nullptr);
  EXPECT_EQ(forms.plane(3)->weight, 2);
  EXPECT_EQ(forms.plane(4), nullptr);
  ASSERT_NE(forms.general(4), nullptr);
  for (int e = 0; e < kFormEntryCount<D>; ++e) {
    EXPECT_EQ((*forms.general(4))[e], static_cast<float>(0.5 * form.matrix[e]));
    EXPECT_EQ((*forms.general(1))[e], static_cast<float>(form.matrix[e]));
  }
}

void expect_limit(const std::function<void()>& set, const std::string& what) {
  try {
    set();
    ADD_FAILURE() << "nothing was thrown: " << what;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit);
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  }
}

TYPED_TEST(SmallGraphTest, RefusesMoreFormsThanItCanTellApart) {
  constexpr int D = TypeParam::value;
  CellForms<D> forms(9, {.planes = 2, .generals = 1, .held_axes = 1});
  const std::vector<std::uint32_t> one{0}, two{1, 2}, three{1, 2, 3};
  forms.reserve_general(one);
  expect_limit([&] { forms.reserve_general(two); }, "more than 1 cells or vertices with surface of several");
  forms.reserve_planes(two);
  expect_limit([&] { forms.reserve_planes(three); }, "more than 2 cells with surface of one direction");
  forms.set_plane(1, {0, 0, 1}, 1);
  forms.set_plane(2, {0, 0, 1}, 1);
  expect_limit([&] { forms.set_plane(3, {0, 0, 1}, 1); }, "more than 2 cells with surface of one direction");
  forms.hold_axis(4, {1, 0, 0});
  expect_limit([&] { forms.hold_axis(5, {1, 0, 0}); }, "more than 1 vertices of tets");
  // What there was before is as it was.
  EXPECT_NE(forms.general(0), nullptr);
  EXPECT_NE(forms.plane(2), nullptr);
  EXPECT_NE(forms.held_axis(4), nullptr);
  for (const std::size_t cell : {3, 5}) EXPECT_TRUE(forms.empty(cell));
}

TYPED_TEST(SmallGraphTest, SolvesAShiftedSystem) {
  constexpr int D = TypeParam::value;
  RandomSamples random(2);
  for (int trial = 0; trial < 20; ++trial) {
    QuadraticForm<D> form;
    for (int n = 0; n < 3; ++n) add_normal(form, random.direction(), random.uniform(0.1, 2));
    const double shift = random.uniform(0.01, 1);
    const Coefficients<D> right = random.coefficients<D>();
    const Coefficients<D> x = solve_shifted<D>(form.matrix, shift, right);
    Coefficients<D> back = matrix_times(form, x);
    add_scaled(back, shift, x);
    // Condition numbers here are below 1000.
    EXPECT_LT(testing::largest_difference(back, right), 1e-12);
  }
}

TEST(RandomFrames, DependOnTheSeedAlone) {
  const auto a = random_frames(100, 7), b = random_frames(100, 7), longer = random_frames(200, 7);
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_EQ(a[i].w, b[i].w);
    EXPECT_EQ(a[i].z, longer[i].z);
  }
}

TEST(RandomFrames, OfDifferentSeedsShareNone) {
  // SplitMix64 steps by this constant: seeds that differ by multiples of it must not give shifted copies.
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15;
  std::set<std::pair<float, float>> seen;
  std::size_t count = 0;
  for (const std::uint64_t seed :
       {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, kStep, 3 * kStep, 6 * kStep}) {
    for (const StoredQuaternion& q : random_frames(200, seed)) seen.emplace(q.w, q.x);
    count += 200;
  }
  EXPECT_EQ(seen.size(), count);
}

TEST(RandomFrames, CoverAllRotationsEvenly) {
  // For rotations drawn uniformly w^2, x^2, y^2 and z^2 average 1/4, and products average 0.
  const auto frames = random_frames(20000, 3);
  std::array<double, 10> mean{};
  for (const StoredQuaternion& q : frames) {
    const double c[4] = {q.w, q.x, q.y, q.z};
    int k = 0;
    for (int a = 0; a < 4; ++a)
      for (int b = a; b < 4; ++b) mean[k++] += c[a] * c[b] / 20000;
  }
  // Five standard deviations of the mean: w^2 has variance 1/16, products 1/24.
  const double expected[10] = {0.25, 0, 0, 0, 0.25, 0, 0, 0.25, 0, 0.25};
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(mean[k], expected[k], 5 * 0.25 / std::sqrt(20000.0));
}

}  // namespace
}  // namespace crossgrain
