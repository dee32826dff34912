// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_extraction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "map/arced_cylinder.hpp"
#include "map/integer_grid_map.hpp"
#include "reduction/demanded_splits.hpp"

namespace crossgrain {
namespace {

using testing::AskewBox;
using Quad = std::array<std::uint32_t, 4>;

constexpr std::array<std::array<std::size_t, 4>, 6> kFaces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Six volumes at a corner with its three neighbours.
double corner_volume(const HexMesh& mesh, const std::array<std::uint32_t, 8>& hexahedron,
                     std::size_t corner) {
  constexpr std::array<std::array<std::size_t, 3>, 8> kNeighbours{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  const auto at = [&](std::size_t k) { return mesh.vertices[hexahedron[k]]; };
  const Vector3 origin = at(corner);
  const auto& [a, b, c] = kNeighbours[corner];
  return dot(cross(at(a) - origin, at(b) - origin), at(c) - origin);
}

/// Numbers of vertices, edges, faces and hexahedra with alternating signs: 1 for a solid without holes.
int euler_number(const HexMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::set<Quad> faces;
  std::map<Quad, int> uses;
  for (const auto& hexahedron : mesh.hexahedra) {
    for (const auto& face : kFaces) {
      Quad quad{};
      for (std::size_t k = 0; k < 4; ++k) {
        quad[k] = hexahedron[face[k]];
        const std::uint32_t a = hexahedron[face[k]], b = hexahedron[face[(k + 1) % 4]];
        edges.insert({std::min(a, b), std::max(a, b)});
      }
      std::sort(quad.begin(), quad.end());
      faces.insert(quad);
      EXPECT_LE(++uses[quad], 2);
    }
  }
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(faces.size()) - static_cast<int>(mesh.hexahedra.size());
}

TEST(HexExtraction, OfABoxIsItsGrid) {
  // 3.6 by 3.3 by 2.4, in hexahedra of 0.4: 9 by 8 by 6.
  const AskewBox box({4, 3, 3}, {0.9, 1.1, 0.8});
  const MapEnergy energy(box.unknowns, 0.4);
  const IntegerGridMap map = integer_grid_map(energy);
  const ExtractedHexahedra found = extracted_hexahedra(box.unknowns, map.coordinates);
  EXPECT_TRUE(found.is_complete());
  EXPECT_EQ(found.mesh.hexahedra.size(), 9u * 8 * 6);
  EXPECT_EQ(found.mesh.vertices.size(), 10u * 9 * 7);
  EXPECT_EQ(euler_number(found.mesh), 1);
  const double cell = 0.4 * (3.3 / 8) * 0.4;
  for (const auto& hexahedron : found.mesh.hexahedra)
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_NEAR(corner_volume(found.mesh, hexahedron, k), cell, 1e-4 * cell);
}

TEST(HexExtraction, OfACylinderFillsItWithFourArcs) {
  const testing::ArcedCylinder cylinder;
  for (const double size : {0.5, 0.2}) {
    const MapEnergy energy(cylinder.unknowns, size);
    const IntegerGridMap map = integer_grid_map(energy);
    ASSERT_EQ(map.flips.tets, 0u);
    const ExtractedHexahedra found = extracted_hexahedra(cylinder.unknowns, map.coordinates);
    EXPECT_TRUE(found.is_complete());
    EXPECT_EQ(euler_number(found.mesh), 1);
    double volume = 0;
    for (const auto& hexahedron : found.mesh.hexahedra) {
      double corners = 0;
      for (std::size_t k = 0; k < 8; ++k) corners += corner_volume(found.mesh, hexahedron, k) / 8;
      volume += corners;
    }
    // Straight edges cut off more of the curved side the longer they are.
    EXPECT_NEAR(volume / volume_of_tets(cylinder.given.mesh), 1, 0.3 * size);
    const auto layers = static_cast<std::size_t>(std::lround(2 / size));
    EXPECT_EQ(found.mesh.hexahedra.size() % layers, 0u);
  }
}

/// The map of a box that is its grid, with inner vertices moved so that it folds.
struct FoldedBox {
  explicit FoldedBox(const AskewBox& box) : energy(box.unknowns, 1), poisson(energy) {
    columns = poisson.columns_for(poisson.relaxed());
    for (double& value : columns) value = std::round(2 * value) / 2;
  }
  MapCoordinates map() const { return energy.basis() * columns; }

  MapEnergy energy;
  PoissonMap poisson;
  Eigen::VectorXd columns;
};

TEST(HexExtraction, IsTheSameWhereTheMapFolds) {
  const AskewBox box({4, 4, 4});
  FoldedBox folded(box);
  ASSERT_EQ(extracted_hexahedra(box.unknowns, folded.map()).mesh.hexahedra.size(), 64u);
  folded.columns[folded.poisson.continuous()[40]] += 2;  // pulls one vertex through its neighbours
  const ExtractedHexahedra found = extracted_hexahedra(box.unknowns, folded.map());
  EXPECT_GT(found.flipped_tets, 0u);
  EXPECT_EQ(found.flipped_tets, flips_of(folded.energy, folded.map()).tets);
  EXPECT_TRUE(found.is_complete());
  EXPECT_EQ(found.mesh.hexahedra.size(), 64u);
  EXPECT_EQ(found.mesh.vertices.size(), 125u);
  EXPECT_EQ(euler_number(found.mesh), 1);
}

TEST(HexExtraction, IsTheGridWhereManyVerticesOfTheMapAreMovedAtRandom) {
  const AskewBox box({4, 4, 4});
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    FoldedBox folded(box);
    for (const std::uint32_t column : folded.poisson.continuous())
      folded.columns[column] += 0.7 * (static_cast<double>(random() % 2000) / 1000 - 1);
    const ExtractedHexahedra found = extracted_hexahedra(box.unknowns, folded.map());
    EXPECT_GT(found.flipped_tets, 10u);
    EXPECT_TRUE(found.is_complete());
    EXPECT_EQ(found.mesh.hexahedra.size(), 64u);
    EXPECT_EQ(found.mesh.vertices.size(), 125u);
    EXPECT_EQ(euler_number(found.mesh), 1);
  }
}

TEST(HexExtraction, IsTheSameForAnyNumberOfThreads) {
  const AskewBox box({3, 3, 3}, {0.9, 1.1, 0.8});
  const MapEnergy energy(box.unknowns, 0.4);
  const IntegerGridMap map = integer_grid_map(energy);
  const auto on = [&](int threads) {
    const ThreadLimit limit(threads);
    return extracted_hexahedra(box.unknowns, map.coordinates).mesh;
  };
  const HexMesh one = on(1), two = on(2);
  EXPECT_EQ(one.vertices, two.vertices);
  EXPECT_EQ(one.hexahedra, two.hexahedra);
}

TEST(HexExtraction, RefusesMapsThatItsNumbersCannotHold) {
  const AskewBox box({2, 2, 2});
  const MapEnergy energy(box.unknowns, 1e-4);
  const PoissonMap poisson(energy);
  EXPECT_THROW(static_cast<void>(extracted_hexahedra(
                   box.unknowns, energy.basis() * poisson.columns_for(poisson.relaxed()))),
               Error);
}

}  // namespace
}  // namespace crossgrain
