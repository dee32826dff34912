// SPDX-License-Identifier: Apache-2.0
#include "grid/grid_level.hpp"

#include <gtest/gtest.h>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"
#include "surface/clipping.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::refined;
using testing::TestSolid;

// Areas are stored in single precision.
constexpr double kStoredArea = 1e-6;

constexpr RootCube kRoundRoot{{-1, -1, -1}, 2};

double area_of_pieces(const GridLevel& level) {
  double sum = 0;
  for (const SurfacePiece& piece : level.pieces) sum += piece.area;
  return sum;
}

/// What the pieces of one cell ought to be: every triangle of the surface clipped to its box.
std::vector<SurfacePiece> pieces_from_scratch(const Surface& surface, const Box& box) {
  const double size = box.high[0] - box.low[0];
  std::vector<SurfacePiece> pieces;
  for (std::uint32_t t = 0; t < surface.size(); ++t) {
    const double area = clip_triangle(surface.corners(t), box).area;
    if (area > 1e-9 * size * size) pieces.push_back({t, static_cast<float>(area)});
  }
  return pieces;
}

/// Uniform to half the depth, then three rounds of refinement of random leaves.
GridLevel randomly_refined(const TestSolid& solid, RandomSamples& random, double cell_size) {
  GridLevel level = solid.level(8 * cell_size);
  for (int round = 0; round < 3; ++round) {
    std::vector<bool> marks(level.size());
    for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = random.uniform(0, 1) < 0.4;
    level = refined(level, solid.solid(), marks);
  }
  return level;
}

TEST(FrameAround, ABoxHasTheCellSizeAskedForAndKeepsMoreThanHalfACellOfMargin) {
  RandomSamples random(1);
  for (int i = 0; i < 500; ++i) {
    const Vector3 low{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Vector3 extent{random.uniform(0, 4), random.uniform(0, 4), random.uniform(0.1, 4)};
    const double cell = random.uniform(0.01, 0.5);
    const GridFrame frame = frame_around({low, low + extent}, cell);
    EXPECT_DOUBLE_EQ(frame.root.cell_size(frame.finest_depth), cell);
    for (int axis = 0; axis < 3; ++axis) {
      // One cell less the largest shift, 0.4337 cells.
      EXPECT_GT(low[axis] - frame.root.origin[axis], 0.56 * cell);
      EXPECT_GT(frame.root.origin[axis] + frame.root.size - (low[axis] + extent[axis]), 0.56 * cell);
    }
  }
}

TEST(FrameAround, ABoxIsNoLargerThanItMustBe) {
  // 62 cells and a margin on either side fill 64; 63 do not.
  EXPECT_EQ(frame_around({{0, 0, 0}, {62, 1, 1}}, 1).finest_depth, 6);
  EXPECT_EQ(frame_around({{0, 0, 0}, {63, 1, 1}}, 1).finest_depth, 7);
}

TEST(FrameAround, ABoxDrawnInRoundNumbersHasNoFaceInACellFace) {
  const GridFrame frame = frame_around({{0, 0, 0}, {32, 24, 10}}, 1);
  for (const double x : {0.0, 5.0, 10.0, 12.5, 24.0, 32.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = x - frame.root.origin[axis];
      EXPECT_GT(std::abs(cells - std::round(cells)), 0.05);
    }
  }
}

TEST(FrameAround, ABoxOfMoreCellsThanAddressesIsALimit) {
  EXPECT_EQ(frame_around({{0, 0, 0}, {524286, 1, 1}}, 1).finest_depth, kMaxDepth);
  try {
    frame_around({{0, 0, 0}, {524287, 1, 1}}, 1);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit);
  }
  EXPECT_THROW(frame_around({{0, 0, 0}, {1, 1, 1}}, 1e-300), Error);
}

TEST(GridLevel, KeepsExactlyTheCellsThatHoldSurfaceOrHaveTheirCentreInside) {
  const TestSolid solid(make_sphere(0.37, 2));
  constexpr int kDepth = 4;
  const GridLevel level = uniform_level(solid.solid(), kRoundRoot, kDepth).level;
  std::size_t active = 0;
  const std::int32_t width = std::int32_t{1} << (kMaxDepth - kDepth);
  for (std::int32_t cell = 0; cell < 16 * 16 * 16; ++cell) {
    const CellAddress address({cell % 16 * width, cell / 16 % 16 * width, cell / 256 * width}, kDepth);
    const Box box = kRoundRoot.box(address);
    const bool expected = !pieces_from_scratch(solid.surface(), box).empty() ||
                          solid.winding().inside(0.5 * (box.low + box.high));
    EXPECT_EQ(level.tree.find_containing(address) != kNoCell, expected);
    active += expected;
  }
  EXPECT_EQ(level.size(), active);
}

TEST(GridLevel, FlagsACentreAsInsideWhereItIs) {
  const Vector3 size{0.9, 0.7, 0.5};
  RandomSamples random(2);
  const Quaternion turn = random.rotation();
  const TestSolid solid(rotate_mesh(make_box(size), turn));
  const GridLevel level = randomly_refined(solid, random, 0.03);
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Vector3 p = rotate(conjugate(turn), level.tree.centre(i));
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) inside &= std::abs(p[axis]) < size[axis] / 2;
    ASSERT_EQ(level.centre_inside(i), inside);
  }
}

TEST(GridLevel, CountsHowOftenTheSurfaceWindsAroundACentre) {
  // Two balls that overlap, so that some centres are inside twice; and an open one, where it is 0 or 1.
  RandomSamples random(7);
  const TriangleMesh ball = make_sphere(0.4, 3);
  TriangleMesh open_ball = ball;
  open_ball.triangles.resize(open_ball.triangles.size() - 3);
  for (const TriangleMesh& mesh : {join_meshes(ball, translate_mesh(ball, {0.3, 0.05, 0.1})), open_ball}) {
    const TestSolid solid(rotate_mesh(mesh, random.rotation()));
    const GridLevel level = randomly_refined(solid, random, 0.03);
    int twice = 0;
    for (CellIndex i = 0; i < level.size(); ++i) {
      const double winding = solid.winding().at(level.tree.centre(i));
      ASSERT_EQ(level.centre_winding[i], solid.solid().closed ? std::lround(winding) : winding > 0.5);
      twice += level.centre_winding[i] == 2;
    }
    EXPECT_EQ(twice > 100, solid.solid().closed) << twice;
  }
}

/// A turned box without its top. The cap over the hole is as flat as the top was: from nowhere else do the
/// other five sides fill half of all directions.
class OpenBox {
 public:
  TriangleMesh mesh() const {
    TriangleMesh box = make_box(size_);
    std::erase_if(box.triangles, [&](const auto& triangle) {
      return std::all_of(triangle.begin(), triangle.end(), [&](auto v) { return box.vertices[v][2] > 0; });
    });
    return rotate_mesh(box, turn_);
  }

  bool holds(const Vector3& point) const {
    const Vector3 p = rotate(conjugate(turn_), point);
    return std::abs(p[0]) < size_[0] / 2 && std::abs(p[1]) < size_[1] / 2 && std::abs(p[2]) < size_[2] / 2;
  }

  bool holds_corner_of(const Box& cell) const {
    for (unsigned k = 0; k < 8; ++k) {
      Vector3 corner = cell.low;
      for (unsigned axis = 0; axis < 3; ++axis) {
        if (k >> axis & 1) corner[axis] = cell.high[axis];
      }
      if (holds(corner)) return true;
    }
    return false;
  }

 private:
  Vector3 size_{0.9, 0.7, 0.5};
  Quaternion turn_ = RandomSamples(8).rotation();
};

TEST(GridLevel, FollowsTheCapOverALargeHoleAtEveryCellSize) {
  const OpenBox box;
  const TestSolid solid(box.mesh());
  ASSERT_EQ(solid.surface().size(), 10u);
  for (const int depth : {2, 3, 4, 5}) {
    const GridLevel level = uniform_level(solid.solid(), kRoundRoot, depth).level;
    const std::int32_t cells = std::int32_t{1} << depth, width = std::int32_t{1} << (kMaxDepth - depth);
    for (std::int32_t cell = 0; cell < cells * cells * cells; ++cell) {
      const GridPoint place{cell % cells, cell / cells % cells, cell / (cells * cells)};
      const CellAddress address({place[0] * width, place[1] * width, place[2] * width}, depth);
      const Box bounds = kRoundRoot.box(address);
      const CellIndex leaf = level.tree.find_containing(address);
      const bool has_surface = !pieces_from_scratch(solid.surface(), bounds).empty();
      ASSERT_EQ(leaf != kNoCell, has_surface || box.holds_corner_of(bounds)) << "depth " << depth;
      if (leaf == kNoCell) continue;
      ASSERT_EQ(level.centre_inside(leaf), box.holds(level.tree.centre(leaf))) << "depth " << depth;
    }
  }
}

TEST(GridLevel, KeepsTrianglesMuchSmallerThanItsCells) {
  // A speck of a box inside nothing: its triangles are far below a billionth of a cell's face.
  const TestSolid solid(
      join_meshes(make_box({1, 1, 1}), translate_mesh(scale_mesh(make_box({1, 1, 1}), 1e-6), {0.8, 0, 0})));
  for (const double cell_size : {0.3, 0.1}) {
    const GridLevel level = solid.level(cell_size);
    std::size_t tiny = 0;
    for (const SurfacePiece& piece : level.pieces) tiny += piece.area < 1e-11;
    EXPECT_GE(tiny, 12u);
  }
}

TEST(GridLevel, OfASolidTurnedInsideOutIsTheSame) {
  const TestSolid solid(make_bracket(16)), inside_out(flip_mesh(make_bracket(16)));
  const GridLevel a = solid.level(0.06), b = inside_out.level(0.06);
  EXPECT_EQ(a.tree.leaves(), b.tree.leaves());
  EXPECT_EQ(a.centre_winding, b.centre_winding);
}

TEST(GridLevel, HoldsTheWholeAreaOfTheSurfaceOnEveryLevel) {
  for (const TriangleMesh& mesh : {make_bracket(24), make_torus(0.6, 0.25, 40, 20), make_sphere(0.8, 3)}) {
    const TestSolid solid(mesh);
    const GridFrame frame = frame_around(solid.surface().box, 0.05);
    for (int depth = 0; depth <= frame.finest_depth; ++depth) {
      const GridLevel level = uniform_level(solid.solid(), frame.root, depth).level;
      EXPECT_NEAR(area_of_pieces(level) / solid.area(), 1, kStoredArea) << "depth " << depth;
    }
  }
}

TEST(GridLevel, HoldsTheWholeAreaWhereLeavesDifferInSize) {
  RandomSamples random(3);
  const TestSolid solid(rotate_mesh(make_bracket(24), random.rotation()));
  for (int trial = 0; trial < 3; ++trial) {
    EXPECT_NEAR(area_of_pieces(randomly_refined(solid, random, 0.03)) / solid.area(), 1, kStoredArea);
  }
}

TEST(GridLevel, CountsASurfaceInCellFacesOnce) {
  // The faces of this box lie in cell faces from depth 2 on.
  const TestSolid solid(make_box({1, 1, 1}));
  for (int depth = 0; depth <= 5; ++depth) {
    const GridLevel level = uniform_level(solid.solid(), kRoundRoot, depth).level;
    EXPECT_NEAR(area_of_pieces(level), 6, 6 * kStoredArea) << "depth " << depth;
  }
}

TEST(GridLevel, GivesASurfaceInACellFaceToTheUpperCell) {
  const TestSolid solid(make_box({1, 1, 1}));
  const GridLevel level = uniform_level(solid.solid(), kRoundRoot, 3).level;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Box box = level.tree.root().box(level.tree[i]);
    for (const SurfacePiece& piece : level.pieces_of(i)) {
      const auto corners = solid.surface().corners(piece.triangle);
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(solid.surface().normals[piece.triangle][axis]) < 0.5) continue;
        EXPECT_EQ(corners[0][axis], box.low[axis]);
      }
    }
  }
}

TEST(GridLevel, HandsDownWhatClippingFromScratchFinds) {
  RandomSamples random(4);
  const TestSolid solid(rotate_mesh(make_bracket(16), random.rotation()));
  const GridLevel level = randomly_refined(solid, random, 0.05);
  std::size_t with_surface = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const auto expected = pieces_from_scratch(solid.surface(), level.tree.root().box(level.tree[i]));
    const auto found = level.pieces_of(i);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      ASSERT_EQ(found[k].triangle, expected[k].triangle);
      ASSERT_EQ(found[k].area, expected[k].area);
    }
    with_surface += level.holds_surface(i);
  }
  EXPECT_GT(with_surface, 500u);
}

TEST(Refined, LevelKnowsWhichLeafEachOfItsLeavesCameFrom) {
  RandomSamples random(5);
  const TestSolid solid(make_bracket(16));
  const GridLevel coarse = solid.level(0.1);
  std::vector<bool> marks(coarse.size());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = random.uniform(0, 1) < 0.3;
  const auto [fine, neighbours, parent] = refined(coarse, face_neighbours(coarse.tree), solid.solid(), marks);
  ASSERT_EQ(parent.size(), fine.size());
  for (CellIndex i = 0; i < fine.size(); ++i) {
    EXPECT_TRUE(coarse.tree[parent[i]].contains(fine.tree[i]));
    EXPECT_EQ(fine.tree[i].depth(), coarse.tree[parent[i]].depth() + (marks[parent[i]] ? 1 : 0));
  }
}

TEST(Refined, LevelIsSortedAndBalanced) {
  RandomSamples random(6);
  const TestSolid solid(make_torus(0.6, 0.25, 30, 16));
  const GridLevel level = randomly_refined(solid, random, 0.03);
  EXPECT_TRUE(std::is_sorted(level.tree.leaves().begin(), level.tree.leaves().end()));
  EXPECT_TRUE(is_balanced(level.tree));
}

TEST(Refined, LevelCountsSevenMoreExaminedLeavesForEverySplit) {
  const TestSolid solid(make_sphere(0.8, 2));
  const GridLevel coarse = solid.level(0.2);
  std::vector<bool> marks(coarse.size(), false);
  marks[0] = marks[coarse.size() / 2] = true;
  const GridLevel fine = refined(coarse, solid.solid(), marks);
  EXPECT_EQ(fine.examined_leaves, coarse.examined_leaves + 14);
}

TEST(Refined, LevelDoesNotDependOnTheThreads) {
  const TestSolid solid(make_bracket(24));
  std::vector<GridLevel> levels;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    levels.push_back(solid.level(0.04));
  }
  for (const GridLevel& level : levels) {
    EXPECT_EQ(level.tree.leaves(), levels[0].tree.leaves());
    EXPECT_EQ(level.piece_begin, levels[0].piece_begin);
    EXPECT_TRUE(std::equal(level.pieces.begin(), level.pieces.end(), levels[0].pieces.begin(),
                           [](const SurfacePiece& a, const SurfacePiece& b) {
                             return a.triangle == b.triangle && a.area == b.area;
                           }));
  }
}

TEST(GridLevel, KnowsTheNeighboursThatTheTreeFinds) {
  RandomSamples random(21);
  const TestSolid solid(rotate_mesh(make_bracket(16), random.rotation()));
  RefinedLevel now{solid.level(0.2), {}, {}};
  const GridLevel& level = now.level;
  now.neighbours = face_neighbours(level.tree);
  for (int round = 0; round < 5; ++round) {
    // Surface here and there, so that leaves of three sizes meet, some of them twice kept and once split.
    std::vector<bool> marks(level.size());
    for (CellIndex i = 0; i < level.size(); ++i)
      marks[i] = random.uniform(0, 1) < (level.holds_surface(i) ? 0.5 : 0.05);
    now = refined(level, now.neighbours, solid.solid(), marks);
    ASSERT_TRUE(is_balanced(level.tree));
    ASSERT_EQ(now.neighbours, face_neighbours(level.tree)) << "in round " << round;
  }
  EXPECT_GT(level.size(), 20000u);
}

}  // namespace
}  // namespace crossgrain
