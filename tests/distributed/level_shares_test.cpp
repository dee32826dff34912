// SPDX-License-Identifier: Apache-2.0
#include "distributed/level_shares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/field_parts.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "distributed/local_files.hpp"
#include "distributed/random_cuts.hpp"
#include "distributed/thread_exchange.hpp"
#include "field/field_data.hpp"
#include "field/leaf_stencil.hpp"
#include "results/output_cells.hpp"
#include "solve/shared_solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::LocalFiles;
using testing::random_cuts;
using testing::run_ranks;

/// Small levels are shared here; read once, so set before anything else.
[[maybe_unused]] const int blocked_cells_set = ::setenv("CROSSGRAIN_BLOCKED_CELLS", "20000", 1);

struct Folders {
  std::string keep, resume;
};

FrameField solved_by(int ranks, const Cuts& cuts, const TriangleMesh& mesh, SolveOptions options,
                     const Folders& folders = {}) {
  options.threads = 2;
  std::optional<FrameField> result;
  run_ranks(ranks, [&](Exchange& exchange) {
    LocalFiles files;
    KeptSolve checkpoint(exchange, files, folders.keep, folders.resume, 0);
    LevelShares shares(exchange, cuts, &checkpoint);
    std::optional<FrameField> field = solve_together(shares, nullptr, mesh, SolveTuning(options), {});
    if (field) field = whole_of_parts(*std::move(field));
    EXPECT_EQ(field.has_value(), exchange.rank() == 0);
    if (field) result = std::move(field);
  });
  return *result;
}

SolveReport without_times(SolveReport report) {
  report.seconds = {};
  report.expected.reset();
  report.peak_memory_bytes = 0;
  for (LevelStatistics& level : report.levels) level.seconds = 0;
  return report;
}

void expect_same(const FrameField& together, const FrameField& alone) {
  const FieldData &a = together.data(), &b = alone.data();
  ASSERT_EQ(a.tree.leaves(), b.tree.leaves());
  EXPECT_EQ(a.open_faces, b.open_faces);
  const auto same = [](const StoredQuaternion& p, const StoredQuaternion& q) {
    return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
  };
  EXPECT_TRUE(std::equal(a.frames.begin(), a.frames.end(), b.frames.begin(), b.frames.end(), same));
  EXPECT_EQ(a.energy_density, b.energy_density);
  EXPECT_EQ(a.alignment_deg, b.alignment_deg);
  EXPECT_EQ(a.constraints, b.constraints);
  EXPECT_EQ(a.regions, b.regions);
  EXPECT_EQ(a.on_boundary, b.on_boundary);
  EXPECT_EQ(report_json(without_times(a.report)), report_json(without_times(b.report)));
  ASSERT_EQ(a.report.levels.size(), b.report.levels.size());
  for (std::size_t k = 0; k < a.report.levels.size(); ++k) {
    const LevelStatistics &one = a.report.levels[k], &other = b.report.levels[k];
    EXPECT_EQ(one.active_cells, other.active_cells) << k;
    EXPECT_EQ(one.cells, other.cells) << k;
    EXPECT_EQ(one.sweeps, other.sweeps) << k;
    EXPECT_EQ(one.energy, other.energy) << k;
  }
  EXPECT_EQ(a.report.walls.tied_cells, b.report.walls.tied_cells);
  EXPECT_EQ(a.report.energy.unavoidable, b.report.energy.unavoidable);
}

SolveOptions at(int resolution, Degree degree = Degree::kFour) {
  SolveOptions options;
  options.resolution = resolution;
  options.degree = degree;
  return options;
}

TEST(LevelShares, OfOneSizeGiveTheFieldOfOneProcess) {
  const TriangleMesh mesh = make_bracket(24);
  const FrameField alone = solve(mesh, at(100));
  ASSERT_GE(alone.size(), blocked_cells());
  for (const int ranks : {1, 3}) expect_same(solved_by(ranks, equal_cuts, mesh, at(100)), alone);
}

TEST(LevelShares, OfAnySizeGiveTheFieldOfOneProcess) {
  const TriangleMesh mesh = make_torus(0.6, 0.25, 48, 24);
  const FrameField alone = solve(mesh, at(80, Degree::kThree));
  ASSERT_GE(alone.size(), blocked_cells());
  for (const int ranks : {3, 8})
    expect_same(solved_by(ranks, random_cuts, mesh, at(80, Degree::kThree)), alone);
}

/// Two boxes with a gap between them, a third through both, and a wall thinner than a cell; each triangle has
/// a face number.
TriangleMesh overlapping_solids() {
  TriangleMesh model;
  const std::vector<std::pair<Vector3, Vector3>> boxes{{{1, 1, 1}, {0, 0, 0}},
                                                       {{1, 1, 1}, {1.2, 0, 0}},
                                                       {{1.4, 0.2, 0.3}, {0.6, 0.1, 0.02}},
                                                       {{2, 1, 0.002}, {0.6, 0, 0.7}}};
  for (const auto& [size, centre] : boxes) {
    model = join_meshes(model, translate_mesh(make_box(size), centre));
    model.solids.resize(model.triangles.size(), static_cast<std::int32_t>(model.solids.size()));
  }
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    model.faces.push_back(static_cast<std::int32_t>(t / 2));
  return model;
}

TEST(LevelShares, OfSeveralSolidsUnderConstraintsGiveTheFieldOfOneProcess) {
  const TriangleMesh mesh = overlapping_solids();
  SolveOptions options = at(64);
  options.constraints.points.push_back({{0.1, 0.1, 0.1}, {{1, 1, 0}}});
  options.constraints.points.push_back({{5, 5, 5}, {{1, 1, 0}}});
  options.constraints.polylines.push_back({{{-1, 0.1, 0.1}, {3, 0.2, 0.2}}});
  options.constraints.faces.push_back({2, {{1, 1, 1}}});
  const FrameField alone = solve(mesh, options);
  ASSERT_GE(alone.size(), blocked_cells());  // levels are shared
  EXPECT_GT(alone.report().regions.size(), 3u);
  EXPECT_GT(alone.report().walls.unresolved_share, 0);
  EXPECT_FALSE(alone.report().warnings.empty());
  expect_same(solved_by(5, random_cuts, mesh, options), alone);
}

TEST(FieldParts, MergeToTheCellsOfTheWholeField) {
  const TriangleMesh mesh = make_bracket(24);
  const FrameField alone = solve(mesh, at(100));
  const std::vector<std::size_t> most{5000, 1000, 1};
  std::vector<FrameField> thinned;
  run_ranks(5, [&](Exchange& exchange) {
    LevelShares shares(exchange, random_cuts);
    SolveOptions options = at(100);
    options.threads = 1;
    const std::optional<FrameField> part = solve_together(shares, nullptr, mesh, SolveTuning(options), {});
    ASSERT_TRUE(part && !part->data().part.is_whole());
    EXPECT_THROW(part->sample({0, 0, 0}), Error);
    for (const std::size_t cells : most) {
      std::optional<FrameField> here = thinned_from_parts(*part, cells);
      EXPECT_EQ(here.has_value(), exchange.rank() == 0);
      if (here) thinned.push_back(*here);
    }
  });
  ASSERT_EQ(thinned.size(), most.size());
  for (std::size_t k = 0; k < most.size(); ++k) {
    EXPECT_LE(thinned[k].size(), most[k]);
    const std::vector<int> levels = thinned[k].levels();
    OutputOptions options;
    options.level = *std::max_element(levels.begin(), levels.end());
    const FieldData expected = output_cells(alone.data(), options), &found = thinned[k].data();
    ASSERT_EQ(found.tree.leaves(), expected.tree.leaves());
    EXPECT_EQ(found.energy_density, expected.energy_density);
    EXPECT_EQ(found.open_faces, expected.open_faces);
    EXPECT_EQ(found.constraints, expected.constraints);
  }
}

TEST(KeptSolve, GoesOnWithOtherSharesToTheSameField) {
  const TriangleMesh mesh = make_bracket(24);
  const std::string folder = ::testing::TempDir() + "crossgrain-kept";
  std::filesystem::remove_all(folder);
  const FrameField kept = solved_by(2, equal_cuts, mesh, at(120), {folder, ""});
  expect_same(solved_by(5, random_cuts, mesh, at(120), {"", folder}), kept);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace crossgrain
