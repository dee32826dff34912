// SPDX-License-Identifier: Apache-2.0
#include "field/nested_solve.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "field/connected_level.hpp"
#include "field/leaf_stencil.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::connect_leaves;
using testing::connectivity_of;
using testing::misorientation_rad;
using testing::RandomSamples;
using testing::TestSolid;

constexpr double kDegree_rad = 3.14159265358979323846 / 180;

SolveTuning options_of(int resolution, Degree degree = Degree::kFour, std::uint64_t seed = 0) {
  SolveTuning options;
  options.resolution = resolution;
  options.degree = degree;
  options.seed = seed;
  return options;
}

SolvedField solved(const TestSolid& solid, const SolveTuning& options) {
  return nested_solve(solid.solid(), options, Monitor());
}

bool same_bits(const std::vector<StoredQuaternion>& a, const std::vector<StoredQuaternion>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StoredQuaternion& p, const StoredQuaternion& q) {
                      return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
                    });
}

class TurnedBoxSolve : public ::testing::TestWithParam<std::tuple<Degree, unsigned>> {};

TEST_P(TurnedBoxSolve, GivesTheBoxsOwnFrameEverywhere) {
  const auto [degree, seed] = GetParam();
  const Quaternion turn = RandomSamples(seed).rotation();
  const TestSolid box(rotate_mesh(make_box({1, 0.8, 0.6}), turn));
  const SolvedField field = solved(box, options_of(16, degree));
  double largest = 0;
  for (const StoredQuaternion& frame : field.frames)
    largest = std::max(largest, misorientation_rad(from_stored(frame), turn));
  EXPECT_LT(largest / kDegree_rad, 0.1);
}

INSTANTIATE_TEST_SUITE_P(DegreesAndRotations, TurnedBoxSolve,
                         ::testing::Combine(::testing::Values(Degree::kThree, Degree::kFour),
                                            ::testing::Values(1u, 2u, 3u)));

TEST(NestedSolve, OfAModelScaledByAPowerOfTwoIsTheSameToTheBit) {
  const TestSolid unit(make_bracket(24));
  const SolvedField expected = solved(unit, options_of(20));
  for (const int power : {-9, 11}) {
    const TestSolid scaled_solid(scale_mesh(make_bracket(24), std::ldexp(1.0, power)));
    const SolvedField field = solved(scaled_solid, options_of(20));
    EXPECT_TRUE(same_bits(field.frames, expected.frames));
    EXPECT_NEAR(std::ldexp(field.energy.total(), -power) / expected.energy.total(), 1, 1e-6);
  }
}

TEST(NestedSolve, IsTheSameToTheBitForOneAndTwoThreads) {
  const TestSolid solid(make_bracket(24));
  std::vector<SolvedField> fields;
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    fields.push_back(solved(solid, options_of(20)));
  }
  EXPECT_TRUE(same_bits(fields[0].frames, fields[1].frames));
  EXPECT_EQ(fields[0].energy.total(), fields[1].energy.total());
  EXPECT_EQ(fields[0].level.tree.leaves(), fields[1].level.tree.leaves());
}

/// (largest - smallest) / smallest of the energies of ten seeds.
double spread_over_seeds(const TestSolid& solid, int resolution) {
  double least = INFINITY, most = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const double energy = solved(solid, options_of(resolution, Degree::kFour, seed)).energy.total();
    least = std::min(least, energy);
    most = std::max(most, energy);
  }
  return most / least - 1;
}

TEST(NestedSolve, FromTenSeedsEndsWithinHalfAPercentOnATorus) {
  EXPECT_LE(spread_over_seeds(TestSolid(make_torus(0.6, 0.25, 64, 32)), 20), 0.005);
}

TEST(NestedSolve, FromTenSeedsEndsWithinAPercentOnASphere) {
  EXPECT_LE(spread_over_seeds(TestSolid(make_sphere(0.8, 4)), 24), 0.01);
}

class DegreeThreeSolve : public ::testing::TestWithParam<const char*> {
 protected:
  static TriangleMesh mesh(const std::string& name) {
    if (name == "torus") return make_torus(0.6, 0.25, 64, 32);
    if (name == "sphere") return make_sphere(0.8, 4);
    return rotate_mesh(make_cylinder(0.55, 0.7, 64), from_rotation_vector({0.21, 0.21, 0}));
  }
};

TEST_P(DegreeThreeSolve, EndsNoMoreThanFivePercentAboveDegreeFour) {
  const TestSolid solid(mesh(GetParam()));
  const double four = solved(solid, options_of(20)).energy.total();
  const double three = solved(solid, options_of(20, Degree::kThree)).energy.total();
  EXPECT_LE(three / four, 1.05);
  // Degree 4 minimises what is compared.
  EXPECT_GE(three / four, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Solids, DegreeThreeSolve, ::testing::Values("cylinder", "torus", "sphere"));

TEST(NestedSolve, DescribesEveryLevel) {
  const TestSolid solid(make_bracket(24));
  const SolvedField field = solved(solid, options_of(20));
  ASSERT_GE(field.levels.size(), 2u);
  for (std::size_t k = 0; k < field.levels.size(); ++k) {
    const LevelStatistics& level = field.levels[k];
    if (k > 0) {
      EXPECT_EQ(level.depth, field.levels[k - 1].depth + 1);
      EXPECT_GT(level.active_cells, field.levels[k - 1].active_cells);
    }
    EXPECT_GE(level.cells, level.active_cells);
    EXPECT_GT(level.sweeps, 0);
    EXPECT_GT(level.energy, 0);
  }
  EXPECT_EQ(field.levels.back().active_cells, field.level.size());
  EXPECT_EQ(field.levels.back().energy, field.energy.total());
}

TEST(NestedSolve, EndsWithTheEnergyOfItsFrames) {
  const TestSolid solid(make_bracket(24));
  const SolveTuning options = options_of(20);
  SolvedField field = solved(solid, options);
  const Adjacency adjacency =
      connectivity_of(field.level, connect_leaves(field.level, solid.solid()), options.solver.diagonal_share)
          .adjacency;
  const LevelEnergy recomputed =
      level_energy(field.level, solid.solid(), adjacency, field.frames, options.solver.boundary_weight);
  const EnergyParts& again = recomputed.parts;
  EXPECT_EQ(field.energy_density, recomputed.neighbours.energy_density);
  EXPECT_EQ(field.energy.smoothness, again.smoothness);
  EXPECT_EQ(field.energy.boundary, again.boundary);
  EXPECT_EQ(field.energy.unavoidable, again.unavoidable);
}

TEST(NestedSolve, HasItsFinestCellsOfTheSizeThatTheResolutionSays) {
  const TestSolid solid(make_bracket(24));  // 1.3 long
  for (const int resolution : {16, 24}) {
    const SolvedField field = solved(solid, options_of(resolution));
    double finest = INFINITY;
    for (CellIndex i = 0; i < field.level.size(); ++i) {
      finest = std::min(finest, field.level.tree.cell_size(i));
      if (field.level.holds_surface(i)) {
        EXPECT_NEAR(field.level.tree.cell_size(i), 1.3 / resolution, 1e-12);
      }
    }
    EXPECT_NEAR(finest, 1.3 / resolution, 1e-12);
  }
}

TEST(NestedSolve, TakesACellSizeInPlaceOfAResolution) {
  const TestSolid solid(make_bracket(24));
  SolveTuning options = options_of(999);
  options.cell_size = 0.1;
  EXPECT_NEAR(solved(solid, options).level.tree.cell_size(0), 0.1, 1e-12);
}

TEST(NestedSolve, StartsFromAGivenFieldWhateverTheSeed) {
  const TestSolid torus(make_torus(0.6, 0.25, 64, 32));
  // The torus' own frames: an axis around it.
  const auto around = [](const Vector3& p) { return from_rotation_vector({0, 0, std::atan2(p[1], p[0])}); };
  const SolvedField a = nested_solve(torus.solid(), options_of(20, Degree::kFour, 1), Monitor(), {around});
  const SolvedField b = nested_solve(torus.solid(), options_of(20, Degree::kFour, 2), Monitor(), {around});
  EXPECT_TRUE(same_bits(a.frames, b.frames));
}

TEST(NestedSolve, StaysWithAGivenFieldThatIsTheSolution) {
  const Quaternion turn = RandomSamples(4).rotation();
  const TestSolid box(rotate_mesh(make_box({1, 0.8, 0.6}), turn));
  const SolvedField field =
      nested_solve(box.solid(), options_of(16), Monitor(), {[&](const Vector3&) { return turn; }});
  for (const StoredQuaternion& frame : field.frames)
    ASSERT_LT(misorientation_rad(from_stored(frame), turn), 0.01 * kDegree_rad);
}

TEST(NestedSolve, StopsAtTheSweepInWhichItIsCancelled) {
  const TestSolid solid(make_sphere(0.8, 3));
  Monitor* cancelled = nullptr;
  int reports = 0;
  Monitor monitor([&](const Progress&) {
    if (++reports == 7) cancelled->cancel();
  });
  cancelled = &monitor;
  try {
    nested_solve(solid.solid(), options_of(24), monitor);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
  EXPECT_EQ(reports, 7);
}

TEST(NestedSolve, CancelledBeforeItStartsReportsNothing) {
  const TestSolid solid(make_sphere(0.8, 3));
  int reports = 0;
  Monitor monitor([&](const Progress&) { ++reports; });
  monitor.cancel();
  EXPECT_THROW(nested_solve(solid.solid(), options_of(24), monitor), Error);
  EXPECT_EQ(reports, 0);
}

TEST(NestedSolve, ReportsEverySweepOfEveryLevelInOrderAndThenItsEnergy) {
  const TestSolid solid(make_bracket(16));
  std::map<int, int> sweeps;
  std::map<int, std::size_t> cells;
  int depth = 0;
  double energy = 0;
  const Monitor monitor([&](const Progress& progress) {
    EXPECT_GE(progress.depth, depth);
    depth = progress.depth;
    const bool of_grid = progress.phase == Phase::kGrid;
    EXPECT_EQ(progress.phase, of_grid ? Phase::kGrid : Phase::kSolve);
    const bool of_level = !of_grid && progress.sweep == sweeps[depth];
    EXPECT_EQ(progress.sweep, of_grid ? 0 : of_level ? sweeps[depth] : ++sweeps[depth]);
    cells[depth] = progress.cells;
    energy = progress.energy;
  });
  const SolvedField field = nested_solve(solid.solid(), options_of(16), monitor);
  EXPECT_EQ(energy, field.energy.total());
  ASSERT_EQ(sweeps.size(), field.levels.size());
  for (const LevelStatistics& level : field.levels) {
    EXPECT_EQ(sweeps[level.depth], level.sweeps);
    EXPECT_EQ(cells[level.depth], level.active_cells);
  }
}

TEST(NestedSolve, OfAnOpenSheetHasFramesAlongItsNormal) {
  // A single open triangle encloses nothing, but its cells hold surface: they get frames along its normal.
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  sheet.triangles = {{0, 1, 2}};
  const TestSolid solid(sheet);
  const SolvedField field = solved(solid, options_of(8));
  for (const StoredQuaternion& frame : field.frames) {
    double best = 0;
    for (const Vector3& axis : axes_of(from_stored(frame))) best = std::max(best, std::abs(axis[2]));
    EXPECT_GT(best, 0.9999);
  }
}

}  // namespace
}  // namespace crossgrain
