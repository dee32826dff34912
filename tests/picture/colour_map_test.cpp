// SPDX-License-Identifier: Apache-2.0
#include "picture/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace crossgrain {
namespace {

std::vector<std::string> texts(const ColourScale& scale) {
  std::vector<std::string> out;
  for (const auto& mark : scale.marks()) out.push_back(mark.text);
  return out;
}

TEST(ColourMap, HasTheFirstAndTheLastColourAtItsEndsAndBeyond) {
  const ColourMap map({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(map.at(0), (Colour{0, 0, 0}));
  EXPECT_EQ(map.at(-3), (Colour{0, 0, 0}));
  EXPECT_EQ(map.at(1), (Colour{1, 1, 1}));
  EXPECT_EQ(map.at(INFINITY), (Colour{1, 1, 1}));
  EXPECT_EQ(map.at(NAN), (Colour{0, 0, 0}));
  EXPECT_EQ(map.at(0.25), (Colour{0.5f, 0, 0}));
}

TEST(ColourScale, IsMarkedAtRoundNumbers) {
  EXPECT_EQ(texts({0, 10}), (std::vector<std::string>{"0", "2", "4", "6", "8", "10"}));
  EXPECT_EQ(texts({-0.5, 0.5}), (std::vector<std::string>{"−0.4", "−0.2", "0", "0.2", "0.4"}));
}

TEST(ColourScale, IsMarkedAtPowersOfTenWhereItIsLogarithmic) {
  EXPECT_EQ(texts({0.01, 100, true}), (std::vector<std::string>{"10⁻²", "10⁻¹", "10⁰", "10¹", "10²"}));
  EXPECT_DOUBLE_EQ((ColourScale{0.01, 100, true}).share_of(1), 0.5);
}

TEST(RoundNumber, IsTheNextThatAPersonWouldTake) {
  for (const auto& [value, round] :
       {std::pair{0.9, 1.0}, {1.0, 1.0}, {1.1, 2.0}, {2.1, 2.5}, {3.0, 5.0}, {51.0, 100.0}})
    EXPECT_DOUBLE_EQ(round_up(value), round);
}

}  // namespace
}  // namespace crossgrain
