// SPDX-License-Identifier: Apache-2.0
#include "picture/singular_lines.hpp"

#include <gtest/gtest.h>

#include "crossgrain/solve.hpp"
#include "picture/mark_shapes.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

const Colour kInk{0, 0, 0};
constexpr std::size_t kFacetsOfDisc = 4 * 24, kFacetsOfDoublePyramid = 8;

DrawnLine line_of(const std::vector<double>& walls, LineKind kind = LineKind::kThree) {
  DrawnLine line{kind, {}, walls, static_cast<double>(walls.size() - 1)};
  for (std::size_t k = 0; k < walls.size(); ++k) line.points.push_back({static_cast<double>(k), 0, 0});
  return line;
}

TEST(SingularLines, AreThinnerInThinWallsWithoutAJump) {
  DrawnLines lines;
  lines.lines.push_back(line_of({kNoWall, 0.06, 0.03, 0.06}));
  const DrawnRods drawn = singular_lines(lines, 0.02, kInk);
  ASSERT_EQ(drawn.rods.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_DOUBLE_EQ(drawn.rods[k].end_radius, lines.lines[0].walls[k + 1] * kLineShareOfWall);
    EXPECT_EQ(drawn.rods[k].radius, k > 0 ? drawn.rods[k - 1].end_radius : 0.02);
  }
}

TEST(SingularLines, AreThickerIfTheyAreImpossible) {
  DrawnLines lines;
  lines.lines = {line_of({kNoWall, kNoWall}), line_of({kNoWall, kNoWall}, LineKind::kImpossible)};
  const DrawnRods drawn = singular_lines(lines, 0.02, kInk);
  EXPECT_GT(drawn.rods[1].radius, drawn.rods[0].radius);
  EXPECT_EQ(drawn.rods[1].colour, kImpossibleLook.colour);
}

TEST(SingularLines, HaveMarksOfDifferentShapes) {
  const auto drawn = [](MarkShape shape, Verdict verdict) {
    DrawnLines lines;
    lines.marks.push_back({shape, {1, 2, 3}, {0, 0, 1}, kNoWall, 1, verdict});
    return singular_lines(lines, 0.02, kInk);
  };
  const DrawnRods node = drawn(MarkShape::kNode, Verdict::kMeshable),
                  end = drawn(MarkShape::kEnd, Verdict::kUndecided),
                  turning = drawn(MarkShape::kTurningPoint, Verdict::kMeshable);
  ASSERT_EQ(node.balls.size(), 1u);
  EXPECT_EQ(node.balls[0].colour, kInk);
  EXPECT_EQ(end.facets.size(), 2 * kFacetsOfDisc) << "with a cap in the colour of the line";
  EXPECT_EQ(end.facets[0].colour, kUndecidedLook.colour);
  EXPECT_EQ(turning.facets.size(), kFacetsOfDoublePyramid);
  EXPECT_TRUE(node.facets.empty() && end.balls.empty() && turning.balls.empty());
  DrawnLines thin;
  thin.marks.push_back({MarkShape::kNode, {}, {}, 0.01, 1, Verdict::kMeshable, LineKind::kThree});
  EXPECT_LT(2 * singular_lines(thin, 0.02, kInk).balls[0].radius, 0.01) << "a mark fits into the wall";
}

TEST(MarkShapes, AreClosedAndSeenFromOutside) {
  const Vector3 centre{0.3, -0.2, 0.5}, axis = normalised({1, 2, -2});
  std::vector<Facet> disc, pyramids, cube;
  add_disc(centre, axis, 1, 0.2, kInk, disc);
  add_double_pyramid(centre, axis, 1, 4, kInk, pyramids);
  add_cube(centre, 1, kInk, cube);
  for (const auto* facets : {&disc, &pyramids, &cube}) {
    Vector3 sum{0, 0, 0};
    for (const Facet& facet : *facets) {
      const auto& [a, b, c] = facet.corners;
      const Vector3 normal = cross(b - a, c - a);
      EXPECT_GT(dot(normal, a - centre), 0);
      sum += normal;
    }
    EXPECT_NEAR(norm(sum), 0, 1e-12);
  }
}

TEST(CrossingsOfACut, AreCapsInThePlane) {
  DrawnRods lines;
  lines.rods = {{{0, 0, -1}, {0, 0, 1}, 0.1, kInk, 0.2}, {{0, 0, 1}, {0, 0, 2}, 0.1, kInk, 0.1}};
  const std::vector<Facet> caps = crossings_of(lines, {0, 0, 1}, 0, kInk);
  EXPECT_EQ(caps.size(), 2 * kFacetsOfDisc) << "a cap and its rim, of the rod that crosses";
  for (const Facet& facet : caps)
    for (const Vector3& corner : facet.corners) {
      EXPECT_LT(std::abs(corner[2]), 0.1);
      EXPECT_LT(norm(corner), 0.3) << "about twice the rod's 0.15";
    }
}

std::vector<std::string> rows_of(const FrameField& field, const SingularityGraph& graph) {
  std::vector<std::string> rows;
  const auto block = legend_of(ShownField(field, &graph), "Lines", kInk);
  if (!block) return rows;
  for (const Sign& sign : block->signs) rows.push_back(sign.text);
  return rows;
}

TEST(LegendOfLines, CountsAsCheckDoes) {
  SolveOptions options;
  options.resolution = 8;
  const FrameField field = solve(make_box({1, 1, 1}), options);
  SingularityGraph graph;
  EXPECT_TRUE(rows_of(field, graph).empty());
  graph.arcs.resize(4);
  for (SingularityGraph::Arc& arc : graph.arcs) arc.points = {{0, 0, 0}, {0, 0, 0.1}};
  graph.arcs[0].index = graph.arcs[1].index = 0.25;
  graph.arcs[1].verdict = Verdict::kUndecided;
  graph.arcs[2].index = -0.25;
  graph.arcs[3].verdict = Verdict::kNotMeshable;
  graph.arcs[3].turning_points = {0, 1};
  graph.nodes = {{{}, false, {0, 1, 2}, Verdict::kNotMeshable},
                 {{}, true, {0}},
                 {{}, true, {1, 2}, Verdict::kUndecided},
                 {{}, true, {3}}};
  EXPECT_EQ(
      rows_of(field, graph),
      (std::vector<std::string>{
          "index +1/4: three hexahedra (2)", "index −1/4: five hexahedra (1)", "impossible for hexahedra (1)",
          "undecided (1)", "turning point: changes its sense (2)", "node: lines meet (2)",
          "node, impossible for hexahedra (1)", "node, undecided (1)", "end on the surface (3)"}));
}

}  // namespace
}  // namespace crossgrain
