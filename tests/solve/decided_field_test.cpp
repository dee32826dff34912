// SPDX-License-Identifier: Apache-2.0
#include "solve/decided_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "crossgrain/error.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "solve/tuned_solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::misorientation_rad;
using testing::TestSolid;

TriangleMesh moved(TriangleMesh mesh, const Quaternion& rotation, const Vector3& shift) {
  for (Vector3& vertex : mesh.vertices) vertex = rotate(rotation, vertex) + shift;
  return mesh;
}

SolveTuning options_of(int resolution, std::size_t decision_cells) {
  SolveTuning options;
  options.resolution = resolution;
  options.solver.decision_cells = decision_cells;
  return options;
}

TEST(DecidedField, HasTheSameAxesOfItsOwnHoweverTheModelLies) {
  const TriangleMesh bracket = make_bracket(32);
  const Quaternion upright = turn_to_own_axes(prepare_surface(bracket));
  const Quaternion rotation = from_rotation_vector({0.4, -1.1, 2.3});
  const Vector3 shift{100, -20, 3};
  const Quaternion turned = turn_to_own_axes(prepare_surface(moved(bracket, rotation, shift)));
  for (const Vector3& vertex : bracket.vertices) {
    const Vector3 apart = rotate(turned, rotate(rotation, vertex)) - rotate(upright, vertex);
    EXPECT_NEAR(norm(apart), 0, 1e-6);
  }
}

TEST(DecidedField, PutsTheLongestSideFirstAndRoundsNothingOfAnUprightModel) {
  const Quaternion turn = turn_to_own_axes(prepare_surface(make_box({1, 3, 2})));
  const Vector3 longest = rotate(turn, {0, 1, 0}), middle = rotate(turn, {0, 0, 1});
  EXPECT_EQ((Vector3{std::abs(longest[0]), longest[1], longest[2]}), (Vector3{1, 0, 0}));
  EXPECT_EQ((Vector3{middle[0], std::abs(middle[1]), middle[2]}), (Vector3{0, 1, 0}));
}

TEST(DecidedField, HasAboutAsManyCellsAsAsked) {
  for (const TriangleMesh& mesh : {make_bracket(32), make_cylinder(0.5, 3, 48), make_torus(1, 0.3, 48, 24)}) {
    const TestSolid part(mesh);
    for (const std::size_t cells : {5000u, 20000u}) {
      const auto decided = DecidedField::solved(part.solid(), options_of(64, cells), Monitor());
      ASSERT_TRUE(decided);
      EXPECT_NEAR(static_cast<double>(decided->field().level.size()) / static_cast<double>(cells), 1, 0.1);
    }
  }
}

TEST(DecidedField, TurnsWithTheModel) {
  const TriangleMesh bracket = make_bracket(32);
  const Quaternion rotation = from_rotation_vector({-0.7, 0.5, 1.9});
  const TestSolid upright(bracket), turned(moved(bracket, rotation, {1, 2, 3}));
  const auto a = DecidedField::solved(upright.solid(), options_of(64, 5000), Monitor());
  const auto b = DecidedField::solved(turned.solid(), options_of(64, 5000), Monitor());
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(b->description().energy / a->description().energy, 1, 1e-3);
  std::size_t alike = 0, all = 0;
  for (const Vector3& vertex : bracket.vertices) {
    const Vector3 inside = 0.97 * vertex;
    const Quaternion expected = rotation * a->frame_at(inside);
    alike += misorientation_rad(expected, b->frame_at(rotate(rotation, inside) + Vector3{1, 2, 3})) < 0.05;
    ++all;
  }
  EXPECT_GT(alike, 95 * all / 100);
}

TEST(DecidedField, IsNotMadeForCellsThatAreMuchLargerOrWhereTheOptionsSaySo) {
  const TestSolid part(make_bracket(32));
  EXPECT_FALSE(DecidedField::solved(part.solid(), options_of(64, 0), Monitor()));
  EXPECT_FALSE(DecidedField::solved(part.solid(), options_of(8, 20000), Monitor()));
}

TEST(DecidedField, EndsWhenItIsStoppedOrCancelled) {
  const TestSolid part(make_bracket(32));
  Monitor stopped, cancelled;
  stopped.allow_stops();
  stopped.stop();
  cancelled.cancel();
  for (const Monitor* monitor : {&stopped, &cancelled}) {
    try {
      DecidedField::solved(part.solid(), options_of(64, 5000), *monitor);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
    }
  }
}

TEST(DecidedField, OfModelsWithTooManyTrianglesLiesAlongTheAxesOfSpace) {
  const TestSolid part(moved(make_box({1, 1, 2}), from_rotation_vector({0, 0, 0.5}), {5, 5, 5}));
  SolveTuning options = options_of(32, 5000);
  const auto extent = [&](int axis) {
    const auto decided = DecidedField::solved(part.solid(), options, Monitor());
    const Octree& tree = decided->field().level.tree;
    Box box = empty_box();
    for (CellIndex i = 0; i < tree.size(); ++i) include(box, tree.centre(i));
    return box.high[axis] - box.low[axis];
  };
  EXPECT_NEAR(extent(0), 2, 0.2) << "the longest side first";
  options.solver.turned_triangles = 11;
  EXPECT_NEAR(extent(2), 2, 0.2);
}

TEST(DecidedField, IsToldOfInTheReportAndHasNoNumbersOfLevels) {
  int last = 0, most = 0;
  std::size_t before = 0;
  bool falls = false;
  const Monitor monitor([&](const Progress& progress) {
    falls = falls || progress.level < last;
    last = progress.level;
    most = std::max(most, progress.levels);
    before += progress.level == 0 && progress.phase == Phase::kSolve;
  });
  const FrameField field = solve(make_bracket(32), options_of(64, 5000), monitor);
  const SolveReport& report = field.report();
  ASSERT_TRUE(report.decision);
  EXPECT_NEAR(static_cast<double>(report.decision->cells), 5000, 500);
  EXPECT_GT(report.decision->energy, 0);
  EXPECT_GT(before, 10u);
  EXPECT_FALSE(falls);
  EXPECT_EQ(last, most);
  EXPECT_EQ(last, static_cast<int>(report.levels.size()));
}

TEST(DecidedField, SettlesIfCellsAreRefinedAroundTheLinesThatRelaxationMoves) {
  const TriangleMesh torus = make_torus(1, 0.5, 64, 32);
  SolveTuning options = options_of(128, SolveTuning().solver.decision_cells);
  const SolveReport refined = solve(torus, options).report();
  EXPECT_TRUE(refined.warnings.empty());
  options.solver.energy_density_threshold = 0.2;
  const SolveReport narrow = solve(torus, options).report();
  ASSERT_EQ(narrow.warnings.size(), 1u);
  EXPECT_EQ(narrow.warnings.front().kind, WarningKind::kNotSettled);
  EXPECT_LT(refined.levels.back().active_cells, narrow.levels.back().active_cells * 5 / 4);
}

TEST(DecidedField, GivesAPartTheSameNumberOfLinesAtEachResolution) {
  for (const int resolution : {48, 56, 64, 80})
    EXPECT_EQ(solve(make_bracket(32), options_of(resolution, 20000)).singularities().arcs.size(), 5u)
        << resolution;
}

}  // namespace
}  // namespace crossgrain
