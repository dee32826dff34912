// SPDX-License-Identifier: Apache-2.0
#include "field/leaf_stencil.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/quaternion.hpp"
#include "field/connected_level.hpp"
#include "field/face_edges.hpp"
#include "field/octree_graph.hpp"
#include "field/solve_tuning.hpp"
#include "field/tet_finish.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::connect_leaves;
using testing::connectivity_of;
using testing::face_edges;
using testing::interior_level;
using testing::RandomSamples;
using testing::refined;
using testing::TestSolid;

/// A cube of 2^depth cells a side, of size 1, all inside and without surface.
GridLevel cubic_level(int depth) {
  Octree tree({{0, 0, 0}, std::ldexp(1.0, depth)}, {CellAddress::root()});
  for (int level = 0; level < depth; ++level)
    tree = testing::split(tree, std::vector<bool>(tree.size(), true));
  return interior_level(std::move(tree));
}

/// A turned bracket with its surface refined once: cut cells, and leaves of two sizes.
GridLevel cut_level(const TestSolid& solid) {
  GridLevel level = solid.level(0.08);
  Marks marks(level.size(), false);
  mark_surface(level, marks);
  return refined(level, solid.solid(), marks);
}

const TestSolid& turned_bracket() {
  static const TestSolid solid(rotate_mesh(make_bracket(16), RandomSamples(3).rotation()));
  return solid;
}

TEST(LeafStencil, GivesALeafInsideEighteenNeighboursOfEqualWeightAtAFifth) {
  // A width whose weights no binary fraction is.
  GridLevel level = cubic_level(3);
  level.tree = Octree({{0, 0, 0}, 8 * 0.7}, level.tree.leaves());
  const auto connectivity = connectivity_of(level, connect_leaves(level, turned_bracket().solid()), 0.2);
  int inside = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Adjacency::Row row = connectivity.adjacency[i];
    const Vector3 centre = level.tree.centre(i);
    if (norm(centre - 0.7 * Vector3{4, 4, 4}) > 0.7 * 3) continue;
    ++inside;
    EXPECT_EQ(row.size(), 18u);
    EXPECT_TRUE(row.has_equal_weights());
    for (const auto& [j, weight] : row) {
      EXPECT_FLOAT_EQ(weight, 0.7f * 0.2f);
      EXPECT_LT(norm(level.tree.centre(j) - centre), 0.7 * 1.5);
    }
  }
  EXPECT_GT(inside, 100);
}

TEST(LeafStencil, WithoutDiagonalsIsTheFaces) {
  const GridLevel level = cut_level(turned_bracket());
  const auto faces = connect_leaves(level, turned_bracket().solid());
  const auto connectivity = connectivity_of(level, faces, 0);
  std::map<std::pair<CellIndex, CellIndex>, float> expected;
  for (const WeightedEdge& face : face_edges(level, faces))
    expected[{face.first, face.second}] = expected[{face.second, face.first}] = face.weight;
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (const auto& [j, weight] : connectivity.adjacency[i]) {
      ASSERT_FLOAT_EQ(expected.at({i, j}), weight);
      expected.erase({i, j});
    }
  }
  EXPECT_TRUE(expected.empty());
}

TEST(LeafStencil, HasTheSameWeightFromBothSidesOfEveryEdgeAndNoneBelowZero) {
  const GridLevel level = cut_level(turned_bracket());
  const auto connectivity = connectivity_of(level, connect_leaves(level, turned_bracket().solid()), 0.25);
  std::map<std::pair<CellIndex, CellIndex>, float> weights;
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (const auto& [j, weight] : connectivity.adjacency[i]) {
      ASSERT_TRUE(weights.insert({{i, j}, weight}).second) << "named twice";
      ASSERT_GE(weight, 0);
    }
  }
  for (const auto& [pair, weight] : weights) ASSERT_EQ(weights.at({pair.second, pair.first}), weight);
}

TEST(LeafStencil, JoinsNoCellsAcrossAnEdgeThatTheSurfaceSeparates) {
  // Two plates with an outside gap thinner than a cell: diagonals must not reach through it.
  const double cell = 0.1, gap = 0.3 * cell;
  const TestSolid plates(make_plates(gap));
  const GridLevel level = uniform_level(plates.solid(), {{-0.83, -0.81, -0.8}, 1.6}, 4).level;
  const auto connectivity = connectivity_of(level, connect_leaves(level, plates.solid()), 0.2);
  std::size_t diagonals = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (const auto& [j, weight] : connectivity.adjacency[i]) {
      ASSERT_EQ(level.tree.centre(i)[2] > 0, level.tree.centre(j)[2] > 0);
      diagonals += norm(level.tree.centre(i) - level.tree.centre(j)) > 1.2 * cell;
    }
  }
  EXPECT_GT(diagonals, level.size());
}

TEST(LeafStencil, CostsALinearFunctionWhatTheFacesAloneCost) {
  RandomSamples random(4);
  const GridLevel level = cut_level(turned_bracket());
  const auto faces = connect_leaves(level, turned_bracket().solid());
  for (int trial = 0; trial < 5; ++trial) {
    const Vector3 gradient = random.vector();
    const auto cost = [&](double share) {
      const auto connectivity = connectivity_of(level, faces, share);
      double sum = 0;
      for (CellIndex i = 0; i < level.size(); ++i) {
        for (const auto& [j, weight] : connectivity.adjacency[i])
          sum += weight / 4 * std::pow(dot(gradient, level.tree.centre(i) - level.tree.centre(j)), 2);
      }
      return sum;
    };
    EXPECT_NEAR(cost(0.2) / cost(0), 1, 1e-6);
  }
}

/// The smoothness energy in a ball of 10 cells around a straight singular arc along `direction`, the mean
/// over where it runs between the cells.
double energy_around_an_arc(const GridLevel& level, const Adjacency& adjacency, const Vector3& direction,
                            RandomSamples& random) {
  const Vector3 axis = normalised(direction);
  const Vector3 u = normalised(cross(axis, std::abs(axis[0]) < 0.8 ? Vector3{1, 0, 0} : Vector3{0, 1, 0}));
  const Vector3 v = cross(axis, u);
  const Quaternion along = with_axis_along({}, axis);
  constexpr int kOffsets = 8;
  double sum = 0;
  for (int k = 0; k < kOffsets; ++k) {
    const Vector3 middle =
        Vector3{16, 16, 16} + Vector3{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    std::vector<Coefficients<4>> h(level.size());
    std::vector<bool> inside(level.size());
    for (CellIndex i = 0; i < level.size(); ++i) {
      const Vector3 p = level.tree.centre(i) - middle;
      const double quarter_turn_rad = std::atan2(dot(p, v), dot(p, u)) / 4;
      h[i] = frame_coefficients<4>(from_rotation_vector(quarter_turn_rad * axis) * along);
      inside[i] = norm(p) < 10;
    }
    for (CellIndex i = 0; i < level.size(); ++i) {
      if (!inside[i]) continue;
      for (const auto& [j, weight] : adjacency[i])
        sum += weight / (inside[j] ? 4 : 2) * squared_norm(difference(h[i], h[j]));
    }
  }
  return sum / kOffsets;
}

TEST(LeafStencil, CostsASingularArcTheSameInAllDirections) {
  const GridLevel level = cubic_level(5);
  const auto faces = connect_leaves(level, turned_bracket().solid());
  const auto spread = [&](double share) {
    const Adjacency adjacency = connectivity_of(level, faces, share).adjacency;
    RandomSamples random(5);
    double least = INFINITY, most = 0;
    for (const Vector3& direction :
         {Vector3{0, 0, 1}, Vector3{0, 1, 1}, Vector3{1, 1, 1}, Vector3{1, 2, 5}}) {
      const double energy = energy_around_an_arc(level, adjacency, direction, random);
      least = std::min(least, energy);
      most = std::max(most, energy);
    }
    return most / least - 1;
  };
  EXPECT_LT(spread(SolverTuning().diagonal_share), 0.015);
  EXPECT_GT(spread(0), 0.05) << "then there would be no need of diagonals";
}

TEST(LeafStencil, ColoursNoTwoNeighboursAlike) {
  // Leaves of three sizes.
  GridLevel level = cut_level(turned_bracket());
  Marks marks(level.size());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = i % 37 == 0;
  level = refined(level, turned_bracket().solid(), marks);
  const auto connectivity = connectivity_of(level, connect_leaves(level, turned_bracket().solid()), 0.2);
  // Up to 200,000 cells every phase is a colour.
  const SweepOrder& order = connectivity.order;
  ASSERT_EQ(order.cells.size(), level.size());
  std::vector<std::size_t> colour(level.size(), SIZE_MAX);
  for (std::size_t phase = 0; phase < order.phase_count(); ++phase) {
    for (std::size_t r = order.phase_begin[phase]; r < order.phase_begin[phase + 1]; ++r)
      for (const CellIndex i : order.run(r)) colour[i] = phase;
  }
  for (CellIndex i = 0; i < level.size(); ++i) {
    ASSERT_NE(colour[i], SIZE_MAX);
    for (const auto& [j, weight] : connectivity.adjacency[i]) ASSERT_NE(colour[i], colour[j]);
  }
}

}  // namespace
}  // namespace crossgrain
