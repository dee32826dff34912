// SPDX-License-Identifier: Apache-2.0
// Turning a part turns its field: on a part without symmetry, at equal cell size.
#include <gtest/gtest.h>

#include "field/nested_solve.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::TestSolid;

constexpr double kDegree_rad = 3.14159265358979323846 / 180;

/// The mean coefficients over a finest cell's cube around p, as a frame: what trilinear interpolation gives
/// on a uniform grid.
Quaternion interpolated(const SolvedField& field, const Vector3& p, double cell_size) {
  constexpr int kSamples = 4;
  const Octree& tree = field.level.tree;
  Coefficients<4> mean{};
  Quaternion nearest;
  double least = INFINITY;
  for (int k = 0; k < kSamples * kSamples * kSamples; ++k) {
    const auto offset = [&](int index) { return ((index % kSamples + 0.5) / kSamples - 0.5) * cell_size; };
    const Vector3 point = p + Vector3{offset(k), offset(k / kSamples), offset(k / kSamples / kSamples)};
    const auto address = tree.root().locate(point);
    const CellIndex cell = address ? tree.find_containing(*address) : kNoCell;
    if (cell == kNoCell) continue;
    add_scaled(mean, 1.0, frame_coefficients<4>(from_stored(field.frames[cell])));
    if (norm(point - p) < least) {
      least = norm(point - p);
      nearest = from_stored(field.frames[cell]);
    }
  }
  return refine_frame<4>(mean, nearest);
}

/// Centres of the cells near singular arcs.
std::vector<Vector3> singular_places(const SolvedField& field) {
  std::vector<Vector3> places;
  for (CellIndex i = 0; i < field.level.size(); ++i) {
    const double size = field.level.tree.cell_size(i);
    if (field.energy_density[i] * size * size > 0.2) places.push_back(field.level.tree.centre(i));
  }
  return places;
}

struct Comparison {
  double p95_deg;     ///< 95th percentile by volume of the angle between frames away from singular cells
  double within_two;  ///< share of that volume within two degrees
  double compared;    ///< share of the solid that is away from singular cells
};

/// Over cells whose centres are at least `away` from singular cells of either field.
Comparison compare(const SolvedField& a, const SolvedField& b, const Quaternion& turn, double cell_size,
                   double away) {
  std::vector<Vector3> singular = singular_places(a);
  for (const Vector3& place : singular_places(b)) singular.push_back(rotate(conjugate(turn), place));
  std::vector<std::pair<double, double>> angles;  // degrees, volume
  double compared = 0, all = 0, within = 0;
  for (CellIndex i = 0; i < a.level.size(); ++i) {
    if (!a.level.centre_inside(i)) continue;
    const Vector3 p = a.level.tree.centre(i);
    const double volume = std::pow(a.level.tree.cell_size(i), 3);
    all += volume;
    if (std::any_of(singular.begin(), singular.end(),
                    [&](const Vector3& place) { return norm(p - place) < away; }))
      continue;
    const Quaternion turned = turn * from_stored(a.frames[i]);
    const double angle_deg =
        testing::misorientation_rad(interpolated(b, rotate(turn, p), cell_size), turned) / kDegree_rad;
    angles.emplace_back(angle_deg, volume);
    compared += volume;
    within += angle_deg < 2 ? volume : 0;
  }
  std::sort(angles.begin(), angles.end());
  double below = 0, p95 = 0;
  for (const auto& [angle_deg, volume] : angles) {
    if (below > 0.95 * compared) break;
    below += volume;
    p95 = angle_deg;
  }
  return {p95, within / compared, compared / all};
}

Comparison turned_bracket(int resolution, double cells_away, unsigned rotation_seed) {
  const TriangleMesh mesh = make_bracket(48);
  const Quaternion turn = RandomSamples(rotation_seed).rotation();
  const TestSolid upright(mesh), turned(rotate_mesh(mesh, turn));
  SolveTuning options;
  options.cell_size = 1.3 / resolution;  // the bracket is 1.3 long
  return compare(nested_solve(upright.solid(), options, Monitor()),
                 nested_solve(turned.solid(), options, Monitor()), turn, options.cell_size,
                 cells_away * options.cell_size);
}

TEST(TurnedPart, HasTheTurnedFramesAtSixtyFourCells) {
  const Comparison comparison = turned_bracket(64, 4, 1);
  EXPECT_GE(comparison.within_two, 0.95) << "95th percentile: " << comparison.p95_deg << " degrees";
  EXPECT_GT(comparison.compared, 0.2) << "hardly anything is away from singular cells";
}

TEST(TurnedPart, HasAFieldThatDiffersLessOnCellsOfHalfTheSize) {
  const Comparison coarse = turned_bracket(24, 4, 2), fine = turned_bracket(48, 8, 2);
  EXPECT_LT(fine.p95_deg, coarse.p95_deg);
}

/// Energies of the turned bracket over that of the upright one, less 1, for several rotations and cells of
/// the upright one across.
std::vector<double> energy_gaps(std::initializer_list<int> resolutions) {
  const TriangleMesh mesh = make_bracket(48);
  std::vector<double> gaps;
  for (const int resolution : resolutions) {
    SolveTuning options;
    options.cell_size = 1.3 / resolution;
    const auto energy = [&](const TriangleMesh& part) {
      return nested_solve(TestSolid(part).solid(), options, Monitor()).energy.total();
    };
    const double upright = energy(mesh);
    for (const unsigned seed : {1, 2, 3})
      gaps.push_back(energy(rotate_mesh(mesh, RandomSamples(seed).rotation())) / upright - 1);
  }
  return gaps;
}

double mean_size(const std::vector<double>& gaps) {
  double sum = 0;
  for (const double gap : gaps) sum += std::abs(gap);
  return sum / static_cast<double>(gaps.size());
}

TEST(TurnedPart, HasTheEnergyWithinSixPercentAndCloserOnCellsOfHalfTheSize) {
  const std::vector<double> coarse = energy_gaps({32, 33}), fine = energy_gaps({63, 64});
  for (const double gap : fine) EXPECT_LT(std::abs(gap), 0.06);
  EXPECT_LT(mean_size(fine), 0.7 * mean_size(coarse));
}

}  // namespace
}  // namespace crossgrain
