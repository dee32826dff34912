// SPDX-License-Identifier: Apache-2.0
// What is known of the singular lines of solved fields.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "field/nested_solve.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/singularity_graph.hpp"
#include "support/cylinder_arcs.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

struct Solved {
  SolvedField field;
  SingularityGraph graph;

  SolveReport::Singularity summary;

  double finest_cell() const { return field.level.tree.root().cell_size(field.levels.back().depth); }
};

/// How a solid is solved: degree and cells across.
using Setting = std::tuple<Degree, int>;
const auto kSettings =
    ::testing::Combine(::testing::Values(Degree::kThree, Degree::kFour), ::testing::Values(16, 24, 32));

std::string name_of(const Setting& setting) {
  const auto [degree, resolution] = setting;
  return (degree == Degree::kThree ? "Degree3On" : "Degree4On") + std::to_string(resolution) + "Cells";
}

Solved solve_coarsely(const TriangleMesh& mesh, const Setting& setting) {
  const Surface surface = prepare_surface(mesh);
  const TriangleBvh bvh(surface);
  const WindingNumber winding(bvh);
  SolveTuning options;
  std::tie(options.degree, options.resolution) = setting;
  Solved solved;
  solved.field = nested_solve({surface, bvh, winding}, options, Monitor());
  solved.graph = singularity_graph(
      singular_grid_edges(solved.field.level.tree, solved.field.frames, solved.field.open_faces));
  solved.summary = summary_of(solved.graph);
  return solved;
}

constexpr double kCylinderRadius = 0.55, kCylinderHalfHeight = 0.7;

class TiltedCylinder : public ::testing::TestWithParam<std::tuple<Vector3, Setting>> {};

TEST_P(TiltedCylinder, HasFourSingularLinesFromCapToCapAndNothingElse) {
  const Quaternion tilt = from_rotation_vector(std::get<Vector3>(GetParam()));
  const auto mesh = rotate_mesh(make_cylinder(kCylinderRadius, kCylinderHalfHeight, 64, 8), tilt);
  const Solved solved = solve_coarsely(mesh, std::get<Setting>(GetParam()));
  EXPECT_EQ(solved.graph.arcs.size(), 4u);
  EXPECT_EQ(solved.summary.nodes, 0u);
  EXPECT_EQ(solved.summary.boundary_ends, 8u);
  // Cap to cap: the last edge may be missing, and where the grid is tilted it is one cell's diagonal away.
  const double reach = kCylinderHalfHeight - 2 * std::sqrt(3.0) * solved.finest_cell();
  for (const auto& arc : solved.graph.arcs) {
    EXPECT_EQ(arc.index, 0.25);
    const double from = rotate(conjugate(tilt), arc.points.front())[2];
    const double to = rotate(conjugate(tilt), arc.points.back())[2];
    EXPECT_GT(std::max(from, to), reach);
    EXPECT_LT(std::min(from, to), -reach);
  }
}

constexpr std::array<Vector3, 3> kTilts{{{0, 0, 0}, {0.212, 0.212, 0}, {0.9, -0.4, 0.3}}};

std::string name_of(const ::testing::TestParamInfo<std::tuple<Vector3, Setting>>& info) {
  const auto& [tilt, setting] = info.param;
  const auto index = std::find(kTilts.begin(), kTilts.end(), tilt) - kTilts.begin();
  return "Tilt" + std::to_string(index) + name_of(setting);
}

INSTANTIATE_TEST_SUITE_P(SingularityOfSolids, TiltedCylinder,
                         ::testing::Combine(::testing::ValuesIn(kTilts), kSettings),
                         [](const auto& cylinder) { return name_of(cylinder); });

/// Of 3 degrees: frames next to a line of a grid turn about an axis between those of the cells.
constexpr double kAxisCosine = 0.9986;

// A fiftieth of the radius is 0.6 of the finest cells here.
TEST(SingularityOfSolids, TheFourLinesOfACylinderAreStraightAndAlikeHoweverItStands) {
  for (const Vector3& tilt : kTilts) {
    const Quaternion rotation = from_rotation_vector(tilt);
    const auto mesh = rotate_mesh(make_cylinder(kCylinderRadius, kCylinderHalfHeight, 128, 8), rotation);
    const Solved solved = solve_coarsely(mesh, {Degree::kFour, 128});
    const CylinderArcs arcs = measure_cylinder_arcs(solved.graph, rotation, kCylinderHalfHeight - 0.2);
    EXPECT_LT(arcs.spread, 0.02);
    EXPECT_LT(arcs.off_straight, 2 * solved.finest_cell());
    const Vector3 upright = rotate(rotation, {0, 0, 1});
    for (const auto& arc : solved.graph.arcs) {
      ASSERT_EQ(arc.axes.size(), arc.points.size());
      EXPECT_TRUE(arc.turning_points.empty());
      for (const Vector3& axis : arc.axes) EXPECT_GT(std::abs(dot(axis, upright)), kAxisCosine);
    }
  }
}

class SolidIn : public ::testing::TestWithParam<Setting> {};

// At 16 cells across, the ends of some lines on the sphere are less than an edge long.
TEST_P(SolidIn, EightLinesReachTheSurfaceOfASphere) {
  const Solved solved = solve_coarsely(make_sphere(0.8, 3), GetParam());
  EXPECT_EQ(solved.summary.boundary_ends, 8u);
}

TEST_P(SolidIn, ATiltedBoxHasNoSingularLine) {
  const Quaternion tilt = from_rotation_vector({0.4, -0.7, 0.5});
  const Solved solved = solve_coarsely(rotate_mesh(make_box({1.4, 1.2, 0.6}), tilt), GetParam());
  EXPECT_EQ(solved.graph.edges, 0u);
}

INSTANTIATE_TEST_SUITE_P(SingularityOfSolids, SolidIn, kSettings,
                         [](const auto& solid) { return name_of(solid.param); });

TEST(SingularityOfSolids, ATorusHasFourClosedLoops) {
  const Solved solved = solve_coarsely(make_torus(0.6, 0.25, 64, 32), {Degree::kFour, 24});
  EXPECT_EQ(solved.graph.arcs.size(), 4u);
  EXPECT_EQ(solved.summary.nodes, 0u);
  EXPECT_EQ(solved.summary.boundary_ends, 0u);
}

}  // namespace
}  // namespace crossgrain
