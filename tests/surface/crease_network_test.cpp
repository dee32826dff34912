// SPDX-License-Identifier: Apache-2.0
#include "surface/crease_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace crossgrain {
namespace {

using Counts = std::vector<std::uint8_t>;

constexpr double kDegree = std::numbers::pi / 180;
constexpr FadingCreases kRule{.sure_deg = 70, .least_radii = 10};

/// Edges of 40 degrees that are one radius long.
std::vector<SharpEdge> edges_of(std::initializer_list<std::array<std::uint32_t, 2>> ends) {
  std::vector<SharpEdge> edges;
  for (const auto& pair : ends) edges.push_back({pair, 40 * kDegree, 1});
  return edges;
}

TEST(CreaseNetwork, DropsAPathThatEndsInTheSmoothSurface) {
  EXPECT_EQ(are_creases(edges_of({{3, 5}, {5, 9}}), {}, kRule), (Counts{0, 0}));
}

TEST(CreaseNetwork, KeepsClosedPathsAndThoseBetweenThem) {
  // Two triangles joined by two edges.
  const auto edges = edges_of({{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 4}});
  EXPECT_EQ(are_creases(edges, {}, kRule), Counts(8, 1));
}

TEST(CreaseNetwork, DropsTheTwigsOfACrease) {
  const auto edges = edges_of({{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {3, 5}});
  EXPECT_EQ(are_creases(edges, {}, kRule), (Counts{1, 1, 1, 0, 0, 0}));
}

TEST(CreaseNetwork, KeepsWhatEndsAtVerticesThatHold) {
  const std::vector<std::uint32_t> both{0, 2}, one{0};
  EXPECT_EQ(are_creases(edges_of({{0, 1}, {1, 2}}), both, kRule), (Counts{1, 1}));
  EXPECT_EQ(are_creases(edges_of({{0, 1}, {1, 2}}), one, kRule), (Counts{0, 0}));
}

TEST(CreaseNetwork, KeepsAFadingPathThatIsSharpOnceOrLong) {
  auto edges = edges_of({{0, 1}, {1, 2}});
  edges[0].turn_rad = 71 * kDegree;
  EXPECT_EQ(are_creases(edges, {}, kRule), (Counts{1, 1}));
  edges[0].turn_rad = 69 * kDegree;
  EXPECT_EQ(are_creases(edges, {}, kRule), (Counts{0, 0}));
  edges[1].radii = 9;
  EXPECT_EQ(are_creases(edges, {}, kRule), (Counts{1, 1}));
  edges[1].radii = 8.9;
  EXPECT_EQ(are_creases(edges, {}, kRule), (Counts{0, 0}));
}

TEST(CreaseNetwork, MeasuresAPathWithoutItsTwigs) {
  // Two pieces of six radii, with a twig of one where they meet.
  auto edges = edges_of({{0, 1}, {1, 2}, {1, 3}});
  edges[0].radii = edges[2].radii = 6;
  EXPECT_EQ(are_creases(edges, {}, kRule), (Counts{1, 0, 1}));
}

TEST(CreaseNetwork, MeasuresTheSameRadiiHoweverFineTheTrianglesAcrossAre) {
  // Edges along a cylinder of radius 1, two long, between rectangles cut in two: centroids of the triangles
  // are two thirds of a side apart.
  for (const int sides : {24, 48, 96}) {
    const double turn_rad = 2 * std::numbers::pi / sides, side = 2 * std::sin(turn_rad / 2);
    EXPECT_NEAR(length_in_radii(turn_rad, 2, 2 * side), 1.5 * 2, 0.01) << sides;
  }
}

TEST(CreaseNetwork, ListsOpenStrandsFromTheirEnds) {
  // A triangle, and a path from it that ends in vertex 4; another one between 9 and 7, where edges hold.
  const auto edges = edges_of({{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {9, 8}, {8, 7}});
  const std::vector<std::uint32_t> holding{9};
  const std::vector<OpenStrand> open = open_strands(edges, holding);
  ASSERT_EQ(open.size(), 2u);
  EXPECT_EQ(open[0].end, 4u);
  EXPECT_EQ(open[0].edges, (std::vector<std::uint32_t>{4, 3}));
  EXPECT_EQ(open[1].end, 7u);
  EXPECT_EQ(open[1].edges, (std::vector<std::uint32_t>{6, 5}));
}

}  // namespace
}  // namespace crossgrain
