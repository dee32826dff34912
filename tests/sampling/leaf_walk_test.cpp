// SPDX-License-Identifier: Apache-2.0
#include "sampling/leaf_walk.hpp"

#include <gtest/gtest.h>

#include <random>

#include "field/made_grid.hpp"

namespace crossgrain {
namespace {

constexpr double kUnits = 1 << kMaxDepth;

struct Grid {
  Octree tree;
  std::vector<StoredQuaternion> frames;
  std::vector<std::uint8_t> open_faces;
  LeafField field() const { return {tree, frames, open_faces}; }

  explicit Grid(Octree of) : tree(std::move(of)), frames(tree.size()), open_faces(testing::all_open(tree)) {}
};

CellIndex leaf_at(const Octree& tree, const Vector3& unit_cube_point) {
  return tree.find_containing(*tree.root().locate(unit_cube_point));
}

Vector3 random_point(std::mt19937& engine) {
  std::uniform_real_distribution<double> uniform(0.001, 0.999);
  return {uniform(engine), uniform(engine), uniform(engine)};
}

TEST(LeafWalk, VisitsTheLeavesThatPointsOnTheWayAreInInTheirOrder) {
  const Grid grid(testing::graded_octree(3));
  const LeafField field = grid.field();
  std::mt19937 engine(1);
  for (int k = 0; k < 300; ++k) {
    const Vector3 from = random_point(engine), to = random_point(engine);
    std::vector<CellIndex> visited{leaf_at(grid.tree, from)};
    const WalkEnd end =
        walk(field, visited[0], kUnits * from, kUnits * to, [&](const PlacedLeaf&, const PlacedLeaf& next) {
          visited.push_back(next.index);
          return true;
        });
    EXPECT_EQ(end.share, 1);
    EXPECT_EQ(end.leaf, leaf_at(grid.tree, to));
    std::size_t place = 0;
    for (int step = 0; step <= 1000; ++step) {
      const CellIndex leaf = leaf_at(grid.tree, from + step / 1000.0 * (to - from));
      while (place < visited.size() && visited[place] != leaf) ++place;
      ASSERT_LT(place, visited.size()) << "leaf " << leaf << " is not visited, or too early";
    }
  }
}

TEST(LeafWalk, EndsWhereTheLeavesDo) {
  // All but the cells of the upper half in x.
  const Octree whole = testing::uniform_octree(3);
  std::vector<CellAddress> leaves;
  for (const CellAddress leaf : whole.leaves()) {
    if (leaf.corner()[0] < kUnits / 2) leaves.push_back(leaf);
  }
  const Grid grid(testing::octree_of(std::move(leaves)));
  const Vector3 from{0.2, 0.33, 0.41}, to{0.8, 0.57, 0.19};
  const WalkEnd end = walk_open(grid.field(), leaf_at(grid.tree, from), kUnits * from, kUnits * to);
  EXPECT_NEAR(end.share, 0.5, 1e-12);
  const WalkEnd out_of_the_root =
      walk_open(grid.field(), leaf_at(grid.tree, from), kUnits * from, kUnits * Vector3{-0.2, 0.33, 0.41});
  EXPECT_NEAR(out_of_the_root.share, 0.5, 1e-12);
}

TEST(LeafWalk, DoesNotPassAClosedFace) {
  Grid grid(testing::uniform_octree(2));
  for (std::uint8_t& faces : grid.open_faces) faces = static_cast<std::uint8_t>(faces & ~0x30);
  const Vector3 from{0.3, 0.3, 0.1}, to{0.3, 0.35, 0.9};
  const WalkEnd end = walk_open(grid.field(), leaf_at(grid.tree, from), kUnits * from, kUnits * to);
  EXPECT_NEAR(end.share, 0.15 / 0.8, 1e-12);
}

TEST(LeafWalk, IsDoneAlsoAlongEdgesAndThroughCornersOfCells) {
  const Grid grid(testing::graded_octree(5));
  const Vector3 corner{0.5, 0.5, 0.5};
  for (const Vector3& way : {Vector3{-0.5, -0.5, -0.5}, Vector3{0.4, 0.4, 0}, Vector3{0, -0.4, 0},
                             Vector3{0.25, -0.25, 0.25}, Vector3{0, 0, 0}}) {
    int visits = 0;
    const WalkEnd end =
        walk(grid.field(), leaf_at(grid.tree, corner), kUnits * corner, kUnits * (corner + way),
             [&](const PlacedLeaf&, const PlacedLeaf&) { return ++visits < 100; });
    EXPECT_EQ(end.share, 1);
  }
}

}  // namespace
}  // namespace crossgrain
