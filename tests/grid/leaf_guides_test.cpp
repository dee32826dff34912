// SPDX-License-Identifier: Apache-2.0
#include "grid/leaf_guides.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "grid/cell_constraints.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"
#include "surface/clipping.hpp"
#include "surface/creases.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::refined;
using testing::TestSolid;

constexpr double kStored = 1e-5;  // single precision, a few hundred terms

/// A level with cells of two sizes.
GridLevel mixed_level(const TestSolid& solid) {
  const GridLevel coarse = solid.level(0.15);
  std::vector<bool> marked(coarse.size());
  for (CellIndex i = 0; i < coarse.size(); ++i) marked[i] = coarse.tree.centre(i)[0] > 0.1;
  return refined(coarse, solid.solid(), marked);
}

/// The length of the segment within a box, by clipping it against the six planes.
double length_within(const GuideSegment& segment, const Box& box) {
  const Vector3 along = segment.ends[1] - segment.ends[0];
  double from = 0, to = 1;
  for (int k = 0; k < 3; ++k) {
    const double low = box.low[k] - segment.ends[0][k], high = box.high[k] - segment.ends[0][k];
    if (along[k] == 0) {
      if (low > 0 || high <= 0) return 0;
      continue;
    }
    from = std::max(from, std::min(low / along[k], high / along[k]));
    to = std::min(to, std::max(low / along[k], high / along[k]));
  }
  return std::max(0.0, to - from) * norm(along);
}

TEST(LeafGuides, WeighTheLengthOfEverySegmentInEveryLeaf) {
  const TestSolid solid(make_sphere(0.8, 3));
  const GridLevel level = mixed_level(solid);
  RandomSamples random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const GuideSegment segment{
        {0.7 * random.direction(), 1.2 * random.direction()}, {random.direction(), random.direction()}, 3};
    const LeafGuides guides(level.tree, {.segments = {segment}});
    for (CellIndex i = 0; i < level.size(); ++i) {
      const double cell = level.tree.cell_size(i);
      double area = 0;
      for (const LeafGuide& guide : guides.of(i)) area += guide.area;
      ASSERT_NEAR(area, 3 * cell * length_within(segment, level.tree.root().box(level.tree[i])),
                  kStored * cell);
    }
  }
}

TEST(LeafGuides, TurnFromOneEndToTheOther) {
  const TestSolid solid(make_sphere(0.8, 3));
  const GridLevel level = solid.level(0.1);
  const GuideSegment segment{{Vector3{-0.6, 0, 0}, {0.6, 0, 0}}, {Vector3{0, 1, 0}, {0, 0, -1}}, 1};
  const LeafGuides guides(level.tree, {.segments = {segment}});
  EXPECT_GE(guides.all().size(), 12u);
  for (const LeafGuide& guide : guides.all()) {
    const double x = level.tree.centre(guide.leaf)[0];
    const Vector3 direction = guide.unit_direction();
    const double expected_rad = std::atan2(0.6 + x, 0.6 - x);
    EXPECT_NEAR(std::atan2(-direction[2], direction[1]), expected_rad, 0.05);
  }
}

TEST(LeafGuides, OfAPointCountLikeAPieceAsLongAsItsCell) {
  const TestSolid solid(make_sphere(0.8, 3));
  const GridLevel level = mixed_level(solid);
  const Vector3 point{0.3, 0.21, -0.17};
  const GuideSegment at_point{{point, point}, {Vector3{1, 0, 0}, {1, 0, 0}}, 2};
  const LeafGuides guides(level.tree, {.segments = {at_point}});
  ASSERT_EQ(guides.all().size(), 1u);
  const double cell = level.tree.cell_size(guides.all()[0].leaf);
  EXPECT_NEAR(guides.all()[0].area, 2 * cell * cell, kStored);
}

TEST(LeafGuides, WeighTheAreaOfEveryFaceInEveryLeaf) {
  const TestSolid solid(make_sphere(0.8, 3));
  const GridLevel level = mixed_level(solid);
  RandomSamples random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Vector3 normal = random.direction();
    const GuideFace face{{0.7 * random.direction(), 1.2 * random.direction(), 0.9 * random.direction()},
                         {normal, -normal, normal},
                         3};
    const LeafGuides guides(level.tree, {.faces = {face}});
    for (CellIndex i = 0; i < level.size(); ++i) {
      double area = 0;
      for (const LeafGuide& guide : guides.of(i)) {
        area += guide.area;
        EXPECT_NEAR(std::abs(dot(guide.unit_direction(), normal)), 1, kStored);
      }
      const Box box = level.tree.root().box(level.tree[i]);
      ASSERT_NEAR(area, 3 * clip_triangle(face.corners, box).area, kStored * level.tree.cell_size(i));
    }
  }
}

TEST(LeafGuides, OfAFaceBlendTheDirectionsOfItsCorners) {
  const TestSolid solid(make_sphere(0.8, 3));
  const GridLevel level = solid.level(0.05);
  const std::array<Vector3, 3> axes{Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const GuideFace face{{0.6 * axes[0], 0.6 * axes[1], 0.6 * axes[2]}, axes, 1};
  const LeafGuides guides(level.tree, {.faces = {face}});
  EXPECT_GE(guides.all().size(), 50u);
  for (const LeafGuide& guide : guides.all()) {
    const Vector3 place = normalised(level.tree.centre(guide.leaf));
    EXPECT_GT(dot(guide.unit_direction(), place), 0.99);
  }
}

TEST(LeafGuides, OfSegmentsCountInCellsOfCornersToo) {
  const TestSolid solid(make_box({1, 1, 1}));
  const GridLevel level = solid.level(0.1);
  const GuideSegment edge{{Vector3{-0.5, -0.5, -0.5}, {0.5, -0.5, -0.5}}, {Vector3{1, 0, 0}, {1, 0, 0}}, 1};
  const std::vector<Vector3> corners{edge.ends[0], edge.ends[1]};
  const LeafGuides as_crease(level.tree, {.creases = {edge}, .corners = corners});
  const LeafGuides as_segment(level.tree, {.corners = corners, .segments = {edge}});
  EXPECT_EQ(as_segment.all().size(), as_crease.all().size() + 2);
}

TEST(LeafGuides, LeaveOutCellsOfCornersAndWhatIsOutside) {
  const TestSolid solid(make_box({1, 1, 1}));
  const GridLevel level = solid.level(0.1);
  const std::vector<CreaseCurve> curves = sharp_curves(solid.surface(), {});
  const std::vector<CreaseCorner> corners = corners_of(curves);
  const LeafGuides all(level.tree, guides_along(curves, {}, 1));
  const LeafGuides between(level.tree, guides_along(curves, corners, 1));
  int left_out = 0;
  for (CellIndex i = 0; i < level.size(); ++i) left_out += all.has(i) && !between.has(i);
  EXPECT_EQ(left_out, 8);
  const GuideSegment outside{{Vector3{2, 2, 2}, {3, 2, 2}}, {Vector3{1, 0, 0}, {1, 0, 0}}, 1};
  EXPECT_TRUE(LeafGuides(level.tree, {.segments = {outside}}).all().empty());
}

TEST(LeafGuides, ArePartOfTheFormsOfCells) {
  const TestSolid box(make_box({1, 1, 1}));
  const std::vector<CreaseCurve> curves = sharp_curves(box.surface(), {});
  const Guides guides = guides_along(curves, corners_of(curves), 1);
  Solid solid = box.solid();
  const GridLevel plain = box.level(0.1);
  solid.guides = &guides;
  const GridLevel guided =
      uniform_level(solid, plain.tree.root(), frame_around(box.surface().box, 0.1).finest_depth).level;
  ASSERT_EQ(guided.size(), plain.size());
  double weight = 0;
  for (CellIndex i = 0; i < plain.size(); ++i)
    weight += cell_form<4>(guided, solid, i).weight - cell_form<4>(plain, solid, i).weight;
  // Twelve edges, but for their ends in corner cells.
  EXPECT_LT(weight, 12 * 0.1);
  EXPECT_GT(weight, 12 * 0.1 * 0.8);
}

}  // namespace
}  // namespace crossgrain
