// SPDX-License-Identifier: Apache-2.0
#include "grid/level_growth.hpp"

#include <gtest/gtest.h>

#include "grid/cell_constraints.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::TestSolid;

constexpr double kMostOff = 1.5;

/// Cells with several normals are few where their number changes much from level to level.
constexpr double kMostOffOfFew = 2;

/// Where points are about as many as cells, how they fall into these is anyone's guess two levels ahead.
constexpr double kMostOffTwoAhead = 2;
constexpr double kCoarsestCell = 0.1;
constexpr int kLevels = 4;

void expect_near(double foretold, double counted, double most_off, const char* what, int ahead) {
  EXPECT_GT(foretold, counted / most_off) << what << ", levels ahead: " << ahead;
  EXPECT_LT(foretold, counted * most_off) << what << ", levels ahead: " << ahead;
}

double cells_of_several_normals(const GridLevel& level, const Solid& solid) {
  double count = 0;
  for (CellIndex i = 0; i < level.size(); ++i)
    count += level.holds_surface(i) && !has_single_normal(level, solid, i);
  return count;
}

class LevelGrowthOf : public ::testing::TestWithParam<const char*> {
 protected:
  static TriangleMesh mesh(const std::string& name) {
    if (name == "sphere") return make_sphere(0.8, 4);
    if (name == "tilted box")
      return rotate_mesh(make_box({1, 0.8, 0.6}), from_rotation_vector({0.3, 0.2, 0.1}));
    if (name == "bracket") return make_bracket(48);
    if (name == "thin wall") return make_wall(0.08);
    return make_torus(0.6, 0.25, 64, 32);
  }
};

TEST_P(LevelGrowthOf, ForetellsTheCountsOfTheNextTwoLevels) {
  const TestSolid part(mesh(GetParam()));
  const Solid solid = part.solid();
  const GridFrame frame = frame_around(solid.surface.box, std::ldexp(kCoarsestCell, -kLevels));
  RefinedLevel made = uniform_level(solid, frame.root, frame.finest_depth - kLevels);
  const GridLevel& level = made.level;
  std::vector<LevelGrowth> growths;
  for (int k = 0; k <= kLevels; ++k) {
    for (int ahead = 1; ahead <= 2 && ahead < static_cast<int>(growths.size()); ++ahead) {
      const LevelCounts foretold = growths[static_cast<std::size_t>(k - ahead)].after(ahead);
      expect_near(foretold.cells, static_cast<double>(level.size()), kMostOff, "cells", ahead);
      expect_near(foretold.pieces, static_cast<double>(level.pieces.size()), kMostOff, "pieces", ahead);
      expect_near(foretold.several_normals, cells_of_several_normals(level, solid), kMostOffOfFew,
                  "several normals", ahead);
    }
    growths.emplace_back(level, solid);
    made = refined(level, made.neighbours, solid,
                   refinement_marks(level, made.neighbours, solid, {}, 0, frame.finest_depth));
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, LevelGrowthOf,
                         ::testing::Values("sphere", "tilted box", "bracket", "thin wall", "torus"));

/// Guides all through a sphere.
Guides made_guides(const std::string& name) {
  testing::RandomSamples random(9);
  Guides guides;
  const auto place = [&] { return 0.7 * std::cbrt(random.uniform(0, 1)) * random.direction(); };
  const Vector3 x{1, 0, 0};
  if (name == "few points")
    for (int k = 0; k < 20; ++k) guides.points.push_back({place(), {x}, {1, 0, 0}, 2});
  if (name == "many points")
    for (int k = 0; k < 2000; ++k) guides.points.push_back({place(), {x}, {1, 0, 0}, 1});
  if (name == "curves")
    for (int k = 0; k < 20; ++k) guides.segments.push_back({{place(), place()}, {x, x}, 1});
  if (name == "faces")
    for (int k = 0; k < 3; ++k) guides.faces.push_back({{place(), place(), place()}, {x, x, x}, 1});
  return guides;
}

class LevelGrowthAlong : public ::testing::TestWithParam<const char*> {};

TEST_P(LevelGrowthAlong, GuidesInsideIsForetold) {
  const TestSolid part(make_sphere(0.8, 4));
  const Guides guides = made_guides(GetParam());
  Solid solid = part.solid();
  solid.guides = &guides;
  const GridFrame frame = frame_around(solid.surface.box, std::ldexp(kCoarsestCell, -kLevels));
  RefinedLevel made = uniform_level(solid, frame.root, frame.finest_depth - kLevels);
  const GridLevel& level = made.level;
  std::vector<LevelGrowth> growths;
  for (int k = 0; k <= kLevels - 1; ++k) {
    for (int ahead = 1; ahead <= 2 && ahead <= static_cast<int>(growths.size()); ++ahead) {
      expect_near(growths[static_cast<std::size_t>(k - ahead)].after(ahead).cells,
                  static_cast<double>(level.size()), ahead == 1 ? kMostOff : kMostOffTwoAhead, "cells",
                  ahead);
    }
    growths.emplace_back(level, solid);
    made = refined(level, made.neighbours, solid,
                   refinement_marks(level, made.neighbours, solid, {}, 0, frame.finest_depth));
  }
}

INSTANTIATE_TEST_SUITE_P(Guides, LevelGrowthAlong,
                         ::testing::Values("few points", "many points", "curves", "faces"));

TEST(LevelGrowth, CountsWhatThereIs) {
  const TestSolid part(make_bracket(24));
  const GridLevel level = part.level(0.05);
  const LevelCounts counts = LevelGrowth(level, part.solid()).after(0);
  EXPECT_EQ(counts.cells, static_cast<double>(level.size()));
  EXPECT_EQ(counts.pieces, static_cast<double>(level.pieces.size()));
  double surface_cells = 0;
  for (CellIndex i = 0; i < level.size(); ++i) surface_cells += level.holds_surface(i);
  EXPECT_EQ(counts.surface_cells, surface_cells);
}

TEST(LevelGrowth, CountsTheCellsOfGuideFacesInside) {
  const TestSolid box(make_box({1, 1, 1}));
  Solid solid = box.solid();
  Guides guides;
  const Vector3 across{0.6, 0, 0.8};
  guides.faces = {
      {{Vector3{0, -0.4, 0}, {0.24, 0.4, -0.18}, {-0.24, 0.4, 0.18}}, {across, across, across}, 1}};
  for (Vector3& corner : guides.faces[0].corners) corner[0] *= 1.2;
  solid.guides = &guides;
  const GridFrame frame = frame_around(solid.surface.box, 1.0 / 48);
  RefinedLevel made = uniform_level(solid, frame.root, frame.finest_depth - 2);
  const GridLevel& level = made.level;
  const LevelGrowth growth(level, solid);
  for (int ahead = 1; ahead <= 2; ++ahead) {
    made = refined(level, made.neighbours, solid,
                   refinement_marks(level, made.neighbours, solid, {}, 0, frame.finest_depth));
    expect_near(growth.after(ahead).cells, static_cast<double>(level.size()), kMostOff, "cells", ahead);
  }
}

}  // namespace
}  // namespace crossgrain
