// SPDX-License-Identifier: Apache-2.0
#include "distributed/level_shares.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "crossgrain/field_parts.hpp"
#include "crossgrain/frame_field.hpp"
#include "distributed/local_files.hpp"
#include "distributed/random_cuts.hpp"
#include "distributed/thread_exchange.hpp"
#include "field/field_data.hpp"
#include "solve/shared_solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::LocalFiles;
using testing::random_cuts;
using testing::run_ranks;

struct Folders {
  std::string keep, resume;
};

FrameField solved_by(int ranks, const Cuts& cuts, const TriangleMesh& mesh, SolveOptions options,
                     const Folders& folders = {}) {
  options.threads = 1;
  std::optional<FrameField> result;
  run_ranks(ranks, [&](Exchange& exchange) {
    LocalFiles files;
    KeptSolve checkpoint(exchange, files, folders.keep, folders.resume, 0);
    LevelShares shares(exchange, cuts, &checkpoint);
    std::optional<FrameField> field = solve_together(shares, nullptr, mesh, options, {});
    if (field) field = whole_of_parts(*std::move(field));
    EXPECT_EQ(field.has_value(), exchange.rank() == 0);
    if (field) result = std::move(field);
  });
  return *result;
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
  const FrameField alone = solve(mesh, at(320));
  for (const int ranks : {1, 3}) expect_same(solved_by(ranks, equal_cuts, mesh, at(320)), alone);
}

TEST(LevelShares, OfAnySizeGiveTheFieldOfOneProcess) {
  const TriangleMesh mesh = make_torus(0.6, 0.25, 96, 48);
  const FrameField alone = solve(mesh, at(240, Degree::kThree));
  for (const int ranks : {3, 8})
    expect_same(solved_by(ranks, random_cuts, mesh, at(240, Degree::kThree)), alone);
}

TEST(KeptSolve, GoesOnWithOtherSharesToTheSameField) {
  const TriangleMesh mesh = make_bracket(24);
  const std::string folder = ::testing::TempDir() + "crossgrain-kept";
  std::filesystem::remove_all(folder);
  const FrameField kept = solved_by(2, equal_cuts, mesh, at(400), {folder, ""});
  expect_same(solved_by(5, random_cuts, mesh, at(400), {"", folder}), kept);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace crossgrain
