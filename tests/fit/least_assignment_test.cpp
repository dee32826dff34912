// SPDX-License-Identifier: Apache-2.0
#include "fit/least_assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

namespace crossgrain {
namespace {

constexpr std::uint32_t kNone = UINT32_MAX;
using Choices = std::vector<AssignmentChoice>;

double cost_of(const std::vector<std::uint32_t>& columns, const Choices& choices, double without) {
  double sum = 0;
  for (std::uint32_t row = 0; row < columns.size(); ++row) {
    if (columns[row] == kNone) {
      sum += without;
      continue;
    }
    double least = INFINITY;
    for (const AssignmentChoice& choice : choices)
      if (choice.row == row && choice.column == columns[row]) least = std::min(least, choice.cost);
    sum += least;
  }
  return sum;
}

double least_by_trying(std::size_t rows, const Choices& choices, double without) {
  std::vector<std::uint32_t> columns(rows + rows);
  for (std::size_t k = 0; k < columns.size(); ++k) columns[k] = k < 4 ? static_cast<std::uint32_t>(k) : kNone;
  std::ranges::sort(columns);
  double least = INFINITY;
  do {
    least = std::min(least, cost_of({columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(rows)},
                                    choices, without));
  } while (std::ranges::next_permutation(columns).found);
  return least;
}

TEST(LeastAssignment, CostsAsLittleAsTheBestOfAllPermutations) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> cost(0, 4);
  for (int trial = 0; trial < 200; ++trial) {
    Choices choices;
    for (std::uint32_t row = 0; row < 4; ++row)
      for (std::uint32_t column = 0; column < 4; ++column)
        if (random() % 3 > 0)
          choices.push_back({row, column, trial % 2 == 0 ? cost(random) : std::round(cost(random))});
    const auto columns = least_assignment(4, choices, 2.5);
    std::set<std::uint32_t> taken;
    for (const std::uint32_t column : columns) EXPECT_TRUE(column == kNone || taken.insert(column).second);
    EXPECT_NEAR(cost_of(columns, choices, 2.5), least_by_trying(4, choices, 2.5), 1e-12);
  }
}

TEST(LeastAssignment, GivesTheSharedColumnToWhoHasNoOther) {
  EXPECT_EQ(least_assignment(2, {{0, 0, 0.1}, {0, 1, 0.5}, {1, 0, 0.3}}, 9),
            (std::vector<std::uint32_t>{1, 0}));
}

}  // namespace
}  // namespace crossgrain
