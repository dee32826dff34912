// SPDX-License-Identifier: Apache-2.0
#include "singularity/surface_hexahedra.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "singularity/matching.hpp"
#include "singularity/solids.hpp"

namespace crossgrain {
namespace {

using Summary = SolveReport::Singularity;

constexpr Vector3 kAlong{0, 0, 1};

/// Outward normal, in the plane, of the first or the second face of an edge along z whose solid reaches from
/// direction 0 to this angle.
std::array<Vector3, 2> normals_at(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return {Vector3{0, -1, 0}, Vector3{-std::sin(angle), std::cos(angle), 0}};
}

Quaternion about_z(double degrees) {
  return from_rotation_vector({0, 0, degrees * std::numbers::pi / 180});
}

/// Frames that follow both faces: turned from one to the other by the rest of the angle.
std::vector<Quaternion> frames_following(double angle_deg, int quarters) {
  std::vector<Quaternion> way;
  for (const double share : {0., 0.25, 0.5, 0.75, 1.})
    way.push_back(about_z(share * (angle_deg - 90 * quarters)));
  return way;
}

TEST(QuarterTurns, OfFramesThatFollowBothFacesAreTheirs) {
  for (int k = 1; k <= 3; ++k)
    for (const double off : {-30., 0., 30.})
      EXPECT_EQ(
          quarter_turns(frames_following(90 * k + off, k), normals_at(90 * k + off), kAlong, 90 * k + off),
          k);
}

TEST(QuarterTurns, OfASlitAndAKnifeAreFourAndNone) {
  EXPECT_EQ(quarter_turns(frames_following(340, 4), normals_at(340), kAlong, 340), 4);
  EXPECT_EQ(quarter_turns(frames_following(20, 0), normals_at(20), kAlong, 20), 0);
}

TEST(QuarterTurns, DoNotDependOnTheNamesOfAxesOrOnTheDirectionsOfSpace) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> entry(-1, 1);
  const Quaternion turn = from_rotation_vector({0.4, 1.1, -0.8});
  for (int k = 1; k <= 3; ++k) {
    std::vector<Quaternion> way = frames_following(90 * k + 20, k);
    for (Quaternion& frame : way) {
      const Quaternion name = to_quaternion(nearest_cube_rotation(
          {1.0 + entry(random), 0.3 * entry(random), 0.7 * entry(random), 0.9 * entry(random)}));
      frame = turn * frame * name;
    }
    auto normals = normals_at(90 * k + 20);
    for (Vector3& normal : normals) normal = rotate(turn, normal);
    EXPECT_EQ(quarter_turns(way, normals, rotate(turn, kAlong), 90 * k + 20), k);
  }
}

/// What frames with these votes on every crease make of a solid.
Summary summary_with(const MadeSolid& solid, int vote, double cell_size = 0.1,
                     const SingularityGraph& graph = {}, bool see_all = true) {
  Summary summary;
  add_surface(
      solid.surface(), solid_creases(solid.surface()),
      [&](const SolidCrease& crease) {
        return std::vector{CreaseVote{vote, crease.length}};
      },
      {[&](std::uint32_t) { return cell_size; }, see_all}, graph, summary);
  return summary;
}

Summary::Corner corner_at(const Summary& summary, const Vector3& place) {
  const auto corner = std::find_if(summary.corner_list.begin(), summary.corner_list.end(),
                                   [&](const auto& it) { return it.place == place; });
  return corner == summary.corner_list.end() ? Summary::Corner{} : *corner;
}

Verdict worst(const Summary& summary) {
  Verdict verdict = Verdict::kMeshable;
  const auto add = [&](const auto& parts) {
    for (const auto& part : parts)
      if (verdict != Verdict::kNotMeshable && part.verdict != Verdict::kMeshable) verdict = part.verdict;
  };
  add(summary.crease_list);
  add(summary.corner_list);
  return verdict;
}

TEST(SurfaceHexahedra, OfAnLHaveOneAtConvexEdgesAndThreeAtTheOther) {
  const Summary summary = summary_with(l_shape(), 1);
  EXPECT_EQ(summary.crease_list.size(), 18u);
  EXPECT_EQ(summary.corner_list.size(), 12u);
  EXPECT_EQ(worst(summary), Verdict::kMeshable);
  EXPECT_EQ(corner_at(summary, {0, 0, 0}).hexahedra, 1);
  EXPECT_EQ(corner_at(summary, {1, 1, 0}).hexahedra, 3);
}

TEST(SurfaceHexahedra, OfAnApexOfFourCreasesAreNone) {
  const Summary::Corner apex = corner_at(summary_with(pyramid(1), 1), {0, 0, 1});
  EXPECT_EQ(apex.creases, (std::vector{1, 1, 1, 1}));
  EXPECT_EQ(apex.hexahedra, 0);
  EXPECT_EQ(apex.verdict, Verdict::kNotMeshable);
}

TEST(SurfaceHexahedra, LeaveNoRoomInAKnifeEdge) {
  EXPECT_EQ(worst(summary_with(wedge(39), 1)), Verdict::kNotMeshable);
  EXPECT_EQ(worst(summary_with(wedge(41), 1)), Verdict::kUndecided);
  EXPECT_EQ(worst(summary_with(wedge(49), 1)), Verdict::kUndecided);
  EXPECT_EQ(worst(summary_with(wedge(51), 1)), Verdict::kMeshable);
}

TEST(SurfaceHexahedra, FollowTheFramesOnlyWhereRoundingDecides) {
  const auto k_of = [](double degrees, int vote) {
    for (const auto& crease : summary_with(wedge(degrees), vote).crease_list)
      if (std::abs(crease.angle_deg - degrees) < 1e-6) return crease.hexahedra;
    return 2;
  };
  EXPECT_EQ(k_of(128, 2), 1);
  EXPECT_EQ(k_of(133, 2), 2);
  EXPECT_EQ(k_of(137, 1), 1);
  EXPECT_EQ(k_of(142, 1), 2);
}

TEST(SurfaceHexahedra, AreUndecidedAtACornerOfCreasesShorterThanTheCells) {
  EXPECT_EQ(corner_at(summary_with(pyramid(1), 1, 1), {0, 0, 1}).verdict, Verdict::kUndecided);
}

TEST(SurfaceHexahedra, DoNotCountRoughnessBelowTheCellsOfAGrid) {
  EXPECT_TRUE(summary_with(pyramid(1), 1, 1, {}, false).corner_list.empty());
  EXPECT_FALSE(summary_with(pyramid(1), 1, 0.1, {}, false).corner_list.empty());
}

TEST(SurfaceHexahedra, TakeInArcsThatEndNearby) {
  // Around a vertex on a flat face an arc may end, and none is needed.
  SingularityGraph graph;
  graph.nodes.push_back({{0, 0, 0.9}, true, {0}, Verdict::kMeshable});
  graph.arcs.emplace_back().index = -0.25;
  const Summary::Corner apex = corner_at(summary_with(pyramid(1), 1, 0.1, graph), {0, 0, 1});
  EXPECT_EQ(apex.verdict, Verdict::kNotMeshable) << "no disc has five triangles inside and four single ones";
}

}  // namespace
}  // namespace crossgrain
