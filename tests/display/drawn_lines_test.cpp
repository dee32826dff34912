// SPDX-License-Identifier: Apache-2.0
#include "display/drawn_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "crossgrain/solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr double kRadius = 0.55, kHalfHeight = 0.7;

FrameField cylinder(const Quaternion& turn) {
  SolveOptions options;
  options.resolution = 32;
  return solve(rotate_mesh(make_cylinder(kRadius, kHalfHeight, 64, 8), turn), options);
}

std::size_t count(const DrawnLines& drawn, MarkShape shape) {
  return static_cast<std::size_t>(
      std::ranges::count_if(drawn.marks, [&](const LineMark& mark) { return mark.shape == shape; }));
}

TEST(DrawnLines, OfACylinderEndInItsCapsHoweverItStands) {
  for (const Vector3& tilt : {Vector3{0, 0, 0}, Vector3{0.212, 0.212, 0}, Vector3{0.9, -0.4, 0.3}}) {
    const Quaternion turn = from_rotation_vector(tilt);
    const FrameField field = cylinder(turn);
    const DrawnLines drawn = drawn_lines(ShownField(field));
    ASSERT_EQ(drawn.lines.size(), 4u);
    ASSERT_EQ(count(drawn, MarkShape::kEnd), 8u);
    EXPECT_EQ(drawn.marks.size(), 8u);
    for (const LineMark& mark : drawn.marks) {
      const Vector3 place = rotate(conjugate(turn), mark.place),
                    normal = rotate(conjugate(turn), mark.direction);
      EXPECT_NEAR(std::abs(place[2]), kHalfHeight, 1e-9);
      EXPECT_LT(std::hypot(place[0], place[1]), kRadius);
      EXPECT_NEAR(normal[2], place[2] > 0 ? 1 : -1, 1e-9) << "outward";
    }
    for (const DrawnLine& line : drawn.lines) {
      EXPECT_EQ(line.kind, LineKind::kThree);
      ASSERT_EQ(line.walls.size(), line.points.size());
      for (std::size_t k = 0; k < line.points.size(); ++k) {
        const Vector3 place = rotate(conjugate(turn), line.points[k]);
        // The chord across the radius through a point off the axis is the shortest; 8 % as walls_along says.
        const double chord = 2 * std::sqrt(kRadius * kRadius - place[0] * place[0] - place[1] * place[1]);
        if (std::abs(place[2]) > kHalfHeight / 2) continue;
        EXPECT_NEAR(line.walls[k], chord, 0.1 * chord);
      }
    }
  }
}

TEST(DrawnLines, AreNoThickerThanAShareOfTheWall) {
  EXPECT_EQ(line_radius(1, kNoWall), 1);
  EXPECT_EQ(line_radius(1, 3), 3 * kLineShareOfWall);
}

/// A box with lines of its own.
class MadeLines : public ::testing::Test {
 protected:
  static FrameField box() {
    SolveOptions options;
    options.resolution = 8;
    return solve(make_box({1, 1, 1}), options);
  }

  /// A line up along z at x, with an end at both sides.
  static SingularityGraph::Arc upright(double x) {
    SingularityGraph::Arc arc;
    for (int k = -4; k <= 4; ++k) arc.points.push_back({x, 0.1, k * 0.125});
    arc.axes.assign(arc.points.size(), {0, 0, 1});
    arc.index = -0.25;
    return arc;
  }
};

TEST_F(MadeLines, HaveAMarkOfEachKindWhereItBelongs) {
  SingularityGraph graph;
  graph.arcs = {upright(0.1), upright(0.1)};
  graph.arcs[0].type = SingularityGraph::ArcType::kChanging;
  graph.arcs[0].verdict = Verdict::kNotMeshable;
  graph.arcs[0].turning_points = {2};
  graph.arcs[0].points.resize(5);
  graph.arcs[0].axes.resize(5);
  graph.arcs[1].points.erase(graph.arcs[1].points.begin(), graph.arcs[1].points.begin() + 4);
  graph.arcs[1].axes.resize(5);
  graph.arcs[0].nodes = {0, 1};
  graph.arcs[1].nodes = {1, 2};
  graph.nodes = {{{0.1, 0.1, -0.5}, true, {0}}, {{0.1, 0.1, 0}, false, {0, 1}}, {{0.1, 0.1, 0.5}, true, {1}}};
  const FrameField field = box();
  const DrawnLines drawn = drawn_lines(ShownField(field, &graph));
  EXPECT_EQ(drawn.lines[0].kind, LineKind::kImpossible);
  EXPECT_EQ(drawn.lines[1].kind, LineKind::kFive);
  ASSERT_EQ(drawn.marks.size(), 4u);
  EXPECT_EQ(drawn.marks[0].shape, MarkShape::kTurningPoint);
  EXPECT_NEAR(norm(drawn.marks[0].place - Vector3{0.1, 0.1, -0.25}), 0, 1e-12);
  EXPECT_NEAR(std::abs(drawn.marks[0].direction[2]), 1, 1e-12);
  EXPECT_EQ(count(drawn, MarkShape::kNode), 1u);
  EXPECT_EQ(count(drawn, MarkShape::kEnd), 2u);
}

TEST_F(MadeLines, ThatMeetOnTheSurfaceStillMeetThere) {
  SingularityGraph graph;
  graph.arcs = {upright(0.1), upright(-0.1)};
  graph.arcs[0].points.back() = graph.arcs[1].points.back() = {0, 0.1, 0.45};
  graph.arcs[0].nodes = {0, 2};
  graph.arcs[1].nodes = {1, 2};
  graph.nodes = {
      {{0.1, 0.1, -0.5}, true, {0}}, {{-0.1, 0.1, -0.5}, true, {1}}, {{0, 0.1, 0.45}, true, {0, 1}}};
  const FrameField field = box();
  const DrawnLines drawn = drawn_lines(ShownField(field, &graph));
  EXPECT_EQ(drawn.lines[0].points.back(), drawn.lines[1].points.back());
  EXPECT_NEAR(norm(drawn.lines[0].points.back() - Vector3{0, 0.1, 0.5}), 0, 1e-12);
  EXPECT_EQ(count(drawn, MarkShape::kNode), 1u) << "it is a node as `check` counts them";
  EXPECT_EQ(count(drawn, MarkShape::kEnd), 3u);
}

}  // namespace
}  // namespace crossgrain
