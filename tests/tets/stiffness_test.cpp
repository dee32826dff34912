// SPDX-License-Identifier: Apache-2.0
#include "tets/stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "crossgrain/thread_limit.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::map<Pair, double> weights_of(const TetMesh& mesh) {
  std::map<Pair, double> weights;
  for (const StiffnessEdge& edge : stiffness_edges(mesh)) weights[{edge.i, edge.j}] = edge.weight;
  return weights;
}

TEST(Stiffness, OfARegularTetIsItsEdgeOverTwelveRootTwo) {
  // Edges of length 2 sqrt 2; each weight is (opposite edge / 6) cot(dihedral), whose cosine is 1/3.
  const TetMesh mesh{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2, 3}}};
  const auto edges = stiffness_edges(mesh);
  ASSERT_EQ(edges.size(), 6u);
  for (const StiffnessEdge& edge : edges) EXPECT_NEAR(edge.weight, 1.0 / 6, 1e-15);
}

/// The three edges of a tet along its way from one end of a cube's diagonal to the other weigh 1/6 each, and
/// its diagonals nothing. The edges of the cube at the ends of its diagonal have two tets each, the others
/// one.
double weight_in_cubes(const Vector3& from, std::size_t axis, double cells) {
  const std::size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
  double weight = 0;
  for (const double low_p : {from[p] - 1, from[p]}) {
    for (const double low_q : {from[q] - 1, from[q]}) {
      if (std::min(low_p, low_q) < 0 || std::max(low_p, low_q) >= cells) continue;
      const bool at_end = (low_p == from[p]) == (low_q == from[q]);
      weight += at_end ? 2.0 / 6 : 1.0 / 6;
    }
  }
  return weight;
}

TEST(Stiffness, OfCubesCutAroundTheirDiagonalsIsTheSevenPointStencil) {
  const TetMesh mesh = TetBox{{3, 3, 3}}.mesh();
  int inside = 0;
  for (const StiffnessEdge& edge : stiffness_edges(mesh)) {
    const Vector3& from = mesh.vertices[edge.i];
    const Vector3 along = mesh.vertices[edge.j] - from;
    if (norm(along) > 1) {
      EXPECT_NEAR(edge.weight, 0, 1e-15);
      continue;
    }
    const std::size_t axis = along[0] == 1 ? 0 : along[1] == 1 ? 1 : 2;
    const double expected = weight_in_cubes(from, axis, 3);
    EXPECT_NEAR(edge.weight, expected, 1e-15);
    inside += expected > 1 - 1e-15;
  }
  // Edges inside the box have all four cubes, and weigh 1.
  EXPECT_EQ(inside, 3 * 2 * 2 * 3);
}

TEST(Stiffness, OfATetIsOppositeEdgeTimesCotangentOfItsDihedral) {
  const TetMesh mesh{{{0.1, 0, 0}, {1, 0.2, -0.1}, {0.3, 0.9, 0.2}, {-0.4, 0.1, 0.7}}, {{0, 1, 2, 3}}};
  const auto weights = weights_of(mesh);
  const auto& v = mesh.vertices;
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (std::uint32_t j = i + 1; j < 4; ++j) {
      std::array<std::uint32_t, 2> far{};
      for (std::uint32_t k = 0, n = 0; k < 4; ++k)
        if (k != i && k != j) far[n++] = k;
      const Vector3 axis = v[far[1]] - v[far[0]];
      const Vector3 to_i = cross(axis, v[i] - v[far[0]]), to_j = cross(axis, v[j] - v[far[0]]);
      const double cotangent = dot(to_i, to_j) / norm(cross(to_i, to_j));
      EXPECT_NEAR(weights.at({i, j}), norm(axis) * cotangent / 6, 1e-14);
    }
  }
}

TEST(Stiffness, GivesTheExactEnergyOfALinearFunction) {
  const TetMesh mesh = solid_of(TetBox{{4, 3, 5}}.mesh(0.2)).mesh;
  const Vector3 gradient{0.7, -1.3, 0.4};
  double energy = 0;
  for (const StiffnessEdge& edge : stiffness_edges(mesh)) {
    const double step = dot(gradient, mesh.vertices[edge.i] - mesh.vertices[edge.j]);
    energy += 0.5 * edge.weight * step * step;
  }
  EXPECT_NEAR(energy, 0.5 * dot(gradient, gradient) * 60, 1e-11);
}

TEST(Stiffness, ListsEveryEdgeOnceInAscendingOrder) {
  const TetMesh mesh = TetBox{{3, 4, 2}}.mesh();
  std::set<Pair> expected;
  for (const auto& tet : mesh.tets)
    for (const std::uint32_t a : tet)
      for (const std::uint32_t b : tet)
        if (a < b) expected.insert({a, b});
  std::vector<Pair> found;
  for (const StiffnessEdge& edge : stiffness_edges(mesh)) found.emplace_back(edge.i, edge.j);
  EXPECT_EQ(found, std::vector<Pair>(expected.begin(), expected.end()));
}

TEST(Stiffness, TakesInvertedTetsAsTurned) {
  TetMesh mesh = TetBox{{2, 2, 2}}.mesh(0.2);
  const auto before = weights_of(mesh);
  const auto after = weights_of(solid_of(mesh).mesh);
  ASSERT_EQ(before.size(), after.size());
  for (const auto& [edge, weight] : before) EXPECT_NEAR(weight, after.at(edge), 1e-14);
}

TEST(Stiffness, GrowsWithLengthAlsoWherePowersOfLengthsDoNotFitADouble) {
  const TetMesh mesh = corner_tet();
  for (const double scale : {0x1p-300, 0x1p300}) {
    TetMesh scaled = mesh;
    for (Vector3& v : scaled.vertices) v = scale * v;
    const auto weights = weights_of(mesh), scaled_weights = weights_of(scaled);
    for (const auto& [edge, weight] : weights) EXPECT_EQ(scaled_weights.at(edge), scale * weight);
  }
}

TEST(Stiffness, IsTheSameToTheBitForAnyNumberOfThreads) {
  const TetMesh mesh = TetBox{{9, 8, 7}}.mesh(0.2);
  const auto with = [&](int threads) {
    const ThreadLimit limit(threads);
    return stiffness_edges(mesh);
  };
  const auto one = with(1), four = with(4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t e = 0; e < one.size(); ++e) EXPECT_EQ(one[e].weight, four[e].weight);
}

}  // namespace
}  // namespace crossgrain
