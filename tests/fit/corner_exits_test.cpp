// SPDX-License-Identifier: Apache-2.0
#include "fit/corner_exits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "base/vector3.hpp"
#include "fit/hex_lattice.hpp"

namespace crossgrain {
namespace {

/// A corner at the origin with ends in these directions, counter-clockwise seen from outside.
FeatureComplex star(const std::vector<Vector3>& directions) {
  FeatureComplex features;
  FeatureComplex::Corner corner{0, {0, 0, 0}, {}, {}};
  features.vertices.push_back({0, 0, 0});
  const auto count = static_cast<std::uint32_t>(directions.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    features.vertices.push_back(directions[k]);
    features.faces.push_back({static_cast<std::int32_t>(k), 1, 0, {}, 1, 1, 1});
    // The face before is on the right, the next on the left.
    features.curves.push_back({{0, k + 1},
                               {0, FeatureComplex::kNone},
                               {{k, true}, {(k + count - 1) % count, false}},
                               false,
                               false,
                               0,
                               1});
    corner.ends.push_back({k, false});
    corner.sectors.push_back({k, (k + 1) % count, k, 1, 0, 1});
  }
  features.corners.push_back(corner);
  return features;
}

/// Cubes around the lattice point (1, 1, 1), which has three to six edges on their surface.
HexMesh cubes_at_a_point(unsigned filled) {
  HexMesh mesh = testing::lattice_mesh(
      {2, 2, 2}, [&](int x, int y, int z) { return static_cast<int>(filled >> (4 * z + 2 * y + x) & 1u); });
  for (Vector3& vertex : mesh.vertices) vertex = vertex - Vector3{1, 1, 1};
  return mesh;
}

std::uint32_t vertex_at_origin(const HexMesh& mesh) {
  const auto found = std::ranges::find(mesh.vertices, Vector3{0, 0, 0});
  return static_cast<std::uint32_t>(found - mesh.vertices.begin());
}

/// Edges around a vertex, counter-clockwise; empty where its quads are not one fan.
std::vector<std::uint32_t> edges_around(const QuadComplex& surface, std::uint32_t vertex) {
  if (surface.quads_of(vertex).empty()) return {};
  std::uint32_t last = 0;
  const auto fan = surface.around(
      vertex, surface.quads_of(vertex)[0], [](std::uint32_t) { return false; }, last);
  if (fan.size() != surface.quads_of(vertex).size() || last == QuadComplex::kNone) return {};
  std::vector<std::uint32_t> edges;
  for (const std::uint32_t quad : fan) edges.push_back(surface.edges_at(quad, vertex)[0]);
  return edges;
}

/// The least sum of 1 - cos over all ways to give ends edges in the same cyclic order.
double least_by_permutations(const HexMesh& mesh, const QuadComplex& surface, std::uint32_t vertex,
                             const std::vector<std::uint32_t>& edges,
                             const std::vector<Vector3>& directions) {
  std::vector<std::size_t> places(edges.size());
  for (std::size_t k = 0; k < places.size(); ++k) places[k] = k;
  double least = INFINITY;
  do {
    std::size_t falls = 0;
    double sum = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      falls += places[(k + 1) % directions.size()] < places[k];
      const Vector3 along = mesh.vertices[surface.other_end(edges[places[k]], vertex)];
      sum += 1 - dot(normalised(along), directions[k]);
    }
    if (falls <= 1) least = std::min(least, sum);
  } while (std::ranges::next_permutation(places).found);
  return least;
}

TEST(CornerExits, TurnAsLittleAsTheBestOfAllPermutationsInCyclicOrder) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const HexMesh mesh = cubes_at_a_point(1 + static_cast<unsigned>(random() % 255));
    const QuadComplex surface(mesh);
    const std::uint32_t vertex = vertex_at_origin(mesh);
    if (vertex == mesh.vertices.size()) continue;
    const auto edges = edges_around(surface, vertex);
    if (edges.size() < 3) continue;
    std::vector<Vector3> directions(2 + random() % 4);
    for (Vector3& direction : directions)
      direction = normalised({normal(random), normal(random), normal(random)});
    const FeatureComplex features = star(directions);
    const SolidSets sets(surface, mesh.vertices.size(), features);
    const CornerExits exits = ExitSearch(mesh, surface, features, sets, 1).exits(0, vertex);
    ASSERT_EQ(exits.fits, directions.size() <= edges.size());
    if (!exits.fits) {
      EXPECT_EQ(exits.missing, directions.size() - edges.size());
      continue;
    }
    ++found;
    EXPECT_NEAR(exits.mean_turn * static_cast<double>(directions.size()),
                least_by_permutations(mesh, surface, vertex, edges, directions), 1e-12);
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace crossgrain
