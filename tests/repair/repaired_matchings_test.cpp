// SPDX-License-Identifier: Apache-2.0
#include "repair/repaired_matchings.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "crossgrain/thread_limit.hpp"
#include "matching/made_matchings.hpp"
#include "matching/repaired_graph.hpp"
#include "repair/matching_repair.hpp"
#include "support/nightly.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::frames_at_centroids;
using testing::random_tet_frames;
using testing::turn_random_faces;
using testing::TurningLine;

const TetSolid kBox = solid_of(TetBox{{5, 5, 5}}.mesh(0.1));
const TetComplex kComplex(kBox);

std::vector<Quaternion> straight_frames() {
  return std::vector<Quaternion>(kBox.mesh.tets.size(), Quaternion{1, 0, 0, 0});
}

TEST(RepairedMatchings, TakeRandomArcsOutOfABox) {
  const auto frames = straight_frames();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    MatchedField field(kComplex, frames);
    turn_random_faces(field, 6, seed);
    MatchingRepair repair(field, RepairWeights{});
    EXPECT_GT(repair.cost(), 0);
    repair.run(RepairTuning{});
    EXPECT_EQ(repair.cost(), 0) << "seed " << seed;
    for (std::uint32_t e = 0; e < kComplex.edges().size(); ++e) {
      if (kComplex.edges()[e].is_on_boundary()) continue;
      EXPECT_FALSE(field.is_singular(e));
    }
  }
}

TEST(RepairedMatchings, KnowTheCostOfTheFieldAfterAllMoves) {
  const auto frames = random_tet_frames(kBox, 3);
  MatchedField field(kComplex, frames);
  RepairTuning options;
  options.wandering_steps = 200;
  MatchingRepair repair(field, RepairWeights{});
  repair.run(options);
  repair.wander(options, 1);
  EXPECT_GT(repair.moves(), 0u);
  EXPECT_NEAR(repair.cost(), MatchingRepair(field, RepairWeights{}).cost(), 1e-9);
}

TEST(RepairedMatchings, LeaveAFieldWithoutFaultsAsItIs) {
  const auto frames = straight_frames();
  const RepairedTets repaired = repaired_tets(MatchedField(kComplex, frames), {});
  EXPECT_EQ(repaired.faults_before, 0u);
  EXPECT_EQ(repaired.faults, 0u);
  EXPECT_EQ(repaired.moves, 0u);
  for (const CubeRotation& matching : repaired.matchings) EXPECT_TRUE(matching.is_identity());
}

TEST(RepairedMatchings, KeepTheArcsThatACylinderNeeds) {
  // Frames that turn with the cylinder leave one line of index 1 along the axis, four arcs of 1/4 at once.
  const TetSolid cylinder = solid_of(tet_cylinder(8));
  const TetComplex complex(cylinder);
  const auto frames = frames_at_centroids(cylinder, [](const Vector3& p) {
    const double radius = std::hypot(p[0], p[1]);
    // Straight near the axis, along the radius at the surface: four lines between.
    const double angle = std::atan2(p[1], p[0]);
    const double quarter = std::numbers::pi / 2;
    const double nearest = angle - quarter * std::round(angle / quarter);
    return from_rotation_vector({0, 0, std::clamp(2.5 * radius - 1.2, 0.0, 1.0) * nearest});
  });
  const RepairedTets repaired = repaired_tets(MatchedField(complex, frames), {});
  EXPECT_EQ(repaired.faults, 0u);
  const MatchedField field(complex, repaired.frames, repaired.matchings);
  const SingularityGraph graph = repaired_graph(field);
  EXPECT_EQ(graph.verdict(), Verdict::kMeshable);
  ASSERT_EQ(graph.arcs.size(), 4u);
  for (const SingularityGraph::Arc& arc : graph.arcs) EXPECT_EQ(arc.index, 0.25);
  EXPECT_EQ(graph.contacts, 0u);
}

TEST(RepairedMatchings, AreTheSameForAnyNumberOfThreads) {
  const auto frames =
      frames_at_centroids(kBox, TurningLine{{2.53, 2.54, 0}, {0, 0.1, 0.995}, {0, 0, 1}, 0.25});
  RepairTuning options;
  options.wandering_steps = 100;
  const auto repaired_on = [&](int threads) {
    const ThreadLimit limit(threads);
    return repaired_tets(MatchedField(kComplex, frames), options);
  };
  const RepairedTets one = repaired_on(1), two = repaired_on(2);
  EXPECT_EQ(one.matchings, two.matchings);
  EXPECT_EQ(one.moves, two.moves);
  for (std::size_t t = 0; t < one.frames.size(); ++t) EXPECT_EQ(one.frames[t].w, two.frames[t].w);
}

TEST(RepairedMatchings, NeverEndWithMoreFaultsThanTheyBeganWith) {
  for (std::uint64_t seed = 1; seed <= (is_nightly() ? 20u : 1u); ++seed) {
    const auto frames = testing::random_tet_frames(kBox, seed);
    RepairTuning options;
    options.tries = {{1, 1, 200}};
    options.disturbances = 2;
    options.finalists = 0;
    const RepairedTets repaired = repaired_tets(MatchedField(kComplex, frames), options);
    EXPECT_LT(repaired.faults, repaired.faults_before);
  }
}

}  // namespace
}  // namespace crossgrain
