// SPDX-License-Identifier: Apache-2.0
#include "grid/point_guides.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::TestSolid;

constexpr double kStored = 1e-6;  // single precision

class PointGuides : public ::testing::Test {
 protected:
  PointGuides() : solid_(make_sphere(0.8, 3)), level_(solid_.level(0.1)) {}

  /// Areas in squared cell sizes, by leaf.
  std::map<CellIndex, double> areas_of(const std::vector<GuidePoint>& points) const {
    std::map<CellIndex, double> areas;
    for (const LeafGuide& guide : guides_at_points(level_.tree, points))
      areas[guide.leaf] += guide.area / std::pow(level_.tree.cell_size(guide.leaf), 2);
    return areas;
  }

  CellIndex leaf_at(const Vector3& place) const {
    return level_.tree.find_containing(*level_.tree.root().locate(place));
  }

  Vector3 centre_near(const Vector3& place) const { return level_.tree.centre(leaf_at(place)); }

  TestSolid solid_;
  GridLevel level_;
};

GuidePoint along_x(const Vector3& place, double weight) {
  return {place, {Vector3{1, 0, 0}}, {weight, 0, 0}};
}

TEST_F(PointGuides, AtTheCentreOfALeafCountThereOnly) {
  const Vector3 centre = centre_near({0.2, 0.1, -0.3});
  const auto areas = areas_of({along_x(centre, 2)});
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(areas.at(leaf_at(centre)), 2, kStored);
}

TEST_F(PointGuides, AtACornerOfLeavesCountAlikeInAllEight) {
  const Vector3 corner = centre_near({0.2, 0.1, -0.3}) + Vector3{0.05, 0.05, 0.05};
  const auto areas = areas_of({along_x(corner, 1)});
  ASSERT_EQ(areas.size(), 8u);
  for (const auto& [leaf, area] : areas) EXPECT_NEAR(area, 1, 1e-4);
}

TEST_F(PointGuides, ChangeEvenlyWithTheirPlace) {
  RandomSamples random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3 place = 0.5 * random.direction();
    const auto before = areas_of({along_x(place, 1)});
    const auto after = areas_of({along_x(place + 1e-6 * random.direction(), 1)});
    for (const auto& [leaf, area] : before) {
      // Small shares are left out.
      if (area < 0.11) continue;
      ASSERT_EQ(after.count(leaf), 1u);
      EXPECT_NEAR(after.at(leaf), area, 1e-3);
    }
  }
}

TEST_F(PointGuides, InOneLeafCountTogetherLikeTheWeightiest) {
  const Vector3 centre = centre_near({0.2, 0.1, -0.3});
  for (const int count : {2, 10, 1000}) {
    std::vector<GuidePoint> points(static_cast<std::size_t>(count), along_x(centre, 1));
    EXPECT_NEAR(areas_of(points).at(leaf_at(centre)), 1, 1e-4);
  }
  // In proportion to their weights, so that one of hardly any does not matter.
  const auto guides = guides_at_points(level_.tree, {along_x(centre, 3), along_x(centre, 1)});
  const double cell = level_.tree.cell_size(leaf_at(centre));
  ASSERT_EQ(guides.size(), 2u);
  EXPECT_NEAR(guides[0].area / (cell * cell), 3 * 0.75, kStored);
  EXPECT_NEAR(guides[1].area / (cell * cell), 0.75, kStored);
}

TEST_F(PointGuides, OutsideAllLeavesAreNone) {
  EXPECT_TRUE(areas_of({along_x({5, 5, 5}, 1), along_x({0.79, 0.79, 0.79}, 1)}).empty());
}

}  // namespace
}  // namespace crossgrain
