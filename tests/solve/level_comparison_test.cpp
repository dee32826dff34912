// SPDX-License-Identifier: Apache-2.0
#include "solve/level_comparison.hpp"

#include <gtest/gtest.h>

#include "solve/tuned_solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Of levels that begin with those below them, not with a field of their own.
SolveReport report_at(const TriangleMesh& mesh, int resolution) {
  SolveTuning options;
  options.resolution = resolution;
  options.solver.decision_cells = 0;
  return solve(mesh, options).report();
}

TEST(LevelComparison, FindsTheFourLinesOfACylinderOnBothLevels) {
  const SolveReport report = report_at(make_cylinder(0.5, 0.7, 64), 48);
  ASSERT_TRUE(report.coarser);
  EXPECT_EQ(report.coarser->arcs, 4u);
  EXPECT_EQ(report.coarser->boundary_ends, 8u);
  EXPECT_EQ(report.coarser->resolution, 24);
  EXPECT_TRUE(report.coarser->differences.empty());
  EXPECT_EQ(report.answer.verdict, Verdict::kMeshable);
}

TEST(LevelComparison, IsWithTheFieldOfHalfTheResolution) {
  const TriangleMesh mesh = make_bracket(32);
  const SolveReport fine = report_at(mesh, 64), coarse = report_at(mesh, 32);
  ASSERT_TRUE(fine.coarser);
  EXPECT_EQ(fine.coarser->arcs, coarse.singularity.arcs);
  EXPECT_EQ(fine.coarser->boundary_ends, coarse.singularity.boundary_ends);
  EXPECT_EQ(fine.coarser->verdict, coarse.singularity.verdict);
}

TEST(LevelComparison, TellsWhichLevelLastChangedTheLines) {
  const TriangleMesh mesh = make_cylinder(0.5, 0.7, 64);
  const SolveReport fine = report_at(mesh, 96);
  ASSERT_TRUE(fine.coarser);
  ASSERT_TRUE(fine.coarser->differences.empty());
  // The level that is named differs from the one below it, and all finer ones have its lines.
  for (int resolution = 48; resolution >= 12; resolution /= 2) {
    const SolveReport report = report_at(mesh, resolution);
    ASSERT_TRUE(report.coarser);
    EXPECT_EQ(report.coarser->last_change == resolution, !report.coarser->differences.empty()) << resolution;
    if (resolution < fine.coarser->last_change) break;
    EXPECT_EQ(report.coarser->last_change, fine.coarser->last_change) << resolution;
  }
  // With every level the same, it is the coarsest: a box has no lines at all.
  EXPECT_EQ(report_at(make_box({1, 1, 1}), 32).coarser->last_change, 4);
}

TEST(LevelComparison, CountsShortLinesToTheSurfaceThatOnlyTheCoarserCellsWouldMerge) {
  SolveTuning options;
  options.resolution = 96;
  const SolveReport report = solve(make_sphere(1, 5), options).report();
  ASSERT_TRUE(report.coarser);
  EXPECT_EQ(report.singularity.arcs, 20u);  // twelve between eight nodes, and one from each to the surface
  EXPECT_EQ(report.coarser->arcs, 20u);
  EXPECT_EQ(report.answer.verdict, Verdict::kMeshable);
}

TEST(LevelComparison, NeedsTwoLevels) {
  EXPECT_FALSE(report_at(make_box({1, 1, 1}), 4).coarser);
}

}  // namespace
}  // namespace crossgrain
