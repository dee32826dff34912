// SPDX-License-Identifier: Apache-2.0
#include "display/cut_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "crossgrain/solve.hpp"
#include "display/cut_lines.hpp"
#include "grid/octree.hpp"
#include "measure/made_tets.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr CutPlane kPlane{2, 0.9};

const ShownField& box_of_tets() {
  static const TetFrameField field = [] {
    SolveOptions options;
    options.resolution = 8;
    return solve_onto(TetDomain(tet_box({3, 3, 3})), options);
  }();
  static const ShownField shown(field);
  return shown;
}

const ShownField& ball() {
  static const FrameField field = [] {
    SolveOptions options;
    options.resolution = 24;
    return solve(make_sphere(1, 3), options);
  }();
  static const ShownField shown(field);
  return shown;
}

double area_of(const CutMesh& mesh) {
  double area = 0;
  for (const CutMesh::Piece& piece : mesh.pieces()) area += piece.size * piece.size;
  return area;
}

TEST(CutMesh, OfTetsFillsTheCrossSection) {
  EXPECT_NEAR(area_of(CutMesh(box_of_tets(), kPlane)), 9, 1e-12);
}

TEST(CutMesh, OfTetsHasEverySideInsideOnce) {
  const CutMesh mesh(box_of_tets(), kPlane);
  double around = 0, inside = 0;
  for (const CutMesh::Piece& piece : mesh.pieces()) {
    const auto corners = mesh.corners(piece);
    for (std::size_t k = 0; k < corners.size(); ++k)
      around += norm(corners[(k + 1) % corners.size()] - corners[k]);
  }
  for (const CutMesh::Side& side : mesh.sides()) inside += norm(side.to - side.from);
  EXPECT_NEAR(around, 2 * inside + 4 * 3, 1e-12);
}

TEST(CutMesh, OfLeavesHasThePieceOfTheLeafAtEachPoint) {
  const ShownField& field = ball();
  const CutMesh mesh(field, {1, 0.03});
  const Octree& tree = field.grid().tree;
  ASSERT_GT(mesh.pieces().size(), 100u);
  for (std::uint32_t i = 0; i < mesh.pieces().size(); ++i) {
    const CutMesh::Piece& piece = mesh.pieces()[i];
    EXPECT_EQ(mesh.piece_at(piece.middle), i);
    const auto cell = tree.root().locate(piece.middle);
    ASSERT_TRUE(cell);
    EXPECT_EQ(tree.find_containing(*cell), piece.element);
  }
  EXPECT_FALSE(mesh.piece_at({5, 0.03, 5}));
}

TEST(CutMesh, OfLeavesJoinsEachPairOnce) {
  const CutMesh mesh(ball(), {0, -0.11});
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const CutMesh::Side& side : mesh.sides()) {
    pairs.emplace_back(std::minmax(side.a, side.b));
    EXPECT_NEAR(norm(side.to - side.from), std::min(mesh.pieces()[side.a].size, mesh.pieces()[side.b].size),
                1e-9);
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
}

TEST(CutMesh, HasNoSeamWhereAllFramesAreAlike) {
  const CutMesh mesh(box_of_tets(), kPlane);
  EXPECT_TRUE(mesh.seams(mesh.named_axes()).empty());
}

TEST(CutMesh, HasSeamsThatEndAtSingularLinesOrTheBoundary) {
  const ShownField& field = ball();
  const CutMesh mesh(field, {2, 0.02});
  const auto seams = mesh.seams(mesh.named_axes());
  ASSERT_FALSE(seams.empty());
  const double cell = field.grid().tree.root().cell_size(field.grid().tree[0].depth());
  for (const auto& seam : seams) {
    for (const Vector3& end : {seam.front(), seam.back()}) {
      double nearest = 1 - norm(end);
      for (const auto& arc : field.lines().arcs)
        for (const Vector3& point : arc.points) nearest = std::min(nearest, norm(point - end));
      EXPECT_LT(nearest, 3 * cell);
    }
  }
}

TEST(CutLines, RunStraightAlongTheAxesOfABoxFromSideToSide) {
  const CutMesh mesh(box_of_tets(), kPlane);
  constexpr double kSpacing = 0.4;
  const auto lines = cut_lines(mesh, mesh.named_axes(), kSpacing, [](const Vector3&) { return true; });
  ASSERT_GT(lines.size(), 10u);
  for (const CutLine& line : lines) {
    ASSERT_EQ(line.names.size() + 1, line.points.size());
    const std::uint8_t along = line.names[0];
    ASSERT_LT(along, 2);
    EXPECT_NEAR(std::abs(line.points.back()[along] - line.points.front()[along]), 3, 1e-3);
    EXPECT_NEAR(line.points.back()[1 - along], line.points.front()[1 - along], 1e-6);
  }
}

TEST(CutLines, HaveOneAlongTheMiddleOfAThinWall) {
  const CutMesh mesh(box_of_tets(), kPlane);
  constexpr double kSpacing = 1;
  const auto along_wall = [&](double thickness) {
    const auto is_inside = [&](const Vector3& p) { return p[1] > 1.35 && p[1] < 1.35 + thickness; };
    auto lines = cut_lines(mesh, mesh.named_axes(), kSpacing, is_inside);
    std::erase_if(lines, [](const CutLine& line) { return line.names[0] != 0; });
    return lines;
  };
  const auto lines = along_wall(0.3);
  ASSERT_EQ(lines.size(), 1u);
  for (const Vector3& point : lines[0].points) EXPECT_NEAR(point[1], 1.5, 1e-3);
  EXPECT_TRUE(along_wall(0.1).empty()) << "would hide the wall";
}

TEST(CutLines, FollowTheEarlierNameOfTwoEquallySteepAxes) {
  TetMesh box = tet_box({3, 3, 3});
  const Quaternion eighth = from_rotation_vector({std::numbers::pi / 4, 0, 0});
  for (Vector3& vertex : box.vertices) vertex = rotate(eighth, vertex);
  SolveOptions solve_options;
  solve_options.resolution = 8;
  const TetFrameField field = solve_onto(TetDomain(box), solve_options);
  const ShownField shown(field);
  const CutMesh mesh(shown, {2, 2.1});
  constexpr double kSpacing = 0.4;
  const auto lines = cut_lines(mesh, mesh.named_axes(), kSpacing, [](const Vector3&) { return true; });
  ASSERT_GT(lines.size(), 10u);
  for (const CutLine& line : lines)
    for (const std::uint8_t name : line.names) EXPECT_LT(name, 2) << "y and z run alike on the cut";
}

TEST(CutLines, GoRoundARingOnce) {
  SolveOptions solve_options;
  solve_options.resolution = 24;
  const FrameField field = solve(make_torus(1, 0.3, 48, 24), solve_options);
  const ShownField shown(field);
  const CutMesh mesh(shown, {2, 0.01});
  constexpr double kSpacing = 0.15;
  const auto is_inside = [](const Vector3& point) {
    return std::abs(std::hypot(point[0], point[1]) - 1) < 0.3;
  };
  for (const CutLine& line : cut_lines(mesh, mesh.named_axes(), kSpacing, is_inside)) {
    double length = 0;
    for (std::size_t k = 1; k < line.points.size(); ++k) length += norm(line.points[k] - line.points[k - 1]);
    EXPECT_LT(length, 2 * 3.15 * 1.3);
  }
}

TEST(CutLines, KeepApartWhereTheyRunAlongTheSameAxis) {
  const CutMesh mesh(ball(), {2, 0.02});
  constexpr double kSpacing = 0.2;
  const auto lines =
      cut_lines(mesh, mesh.named_axes(), kSpacing, [](const Vector3& point) { return norm(point) < 1; });
  ASSERT_GT(lines.size(), 10u);
  for (const CutLine& a : lines) {
    for (const CutLine& b : lines) {
      if (&a == &b) continue;
      for (std::size_t i = 1; i + 1 < a.points.size(); ++i) {
        for (std::size_t j = 1; j + 1 < b.points.size(); ++j) {
          if (norm(a.points[i] - b.points[j]) > 0.5 * 0.55 * kSpacing) continue;
          const Vector3 u = a.points[i + 1] - a.points[i - 1], v = b.points[j + 1] - b.points[j - 1];
          EXPECT_LT(std::abs(dot(u, v)), 0.8 * norm(u) * norm(v));
        }
      }
    }
  }
}

}  // namespace
}  // namespace crossgrain
