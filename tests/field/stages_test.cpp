// SPDX-License-Identifier: Apache-2.0
// Relaxation and settling as the two stages of one solve.
#include "field/stages.hpp"
#include "field/connected_level.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "field/cell_colours.hpp"
#include "field/leaf_stencil.hpp"
#include "field/octree_graph.hpp"
#include "field/solve_tuning.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::connect_leaves;
using testing::connectivity_of;
using testing::TestSolid;

using Frames = std::vector<StoredQuaternion>;

// States are stored in single precision, energies are sums of a few thousand terms of either sign.
constexpr double kStored = 2e-6;

void ignore(double) {}

bool same_bits(const Frames& a, const Frames& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StoredQuaternion& p, const StoredQuaternion& q) {
                      return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
                    });
}

template <class Degree>
class Stages : public ::testing::Test {
 protected:
  static constexpr int D = Degree::value;

  Stages() {
    const TestSolid bracket(make_bracket(16));
    const GridLevel level = bracket.level(0.08);
    const LeafConnections connections = connect_leaves(level, bracket.solid());
    graph_ = {std::make_shared<const Connectivity>(
                  connectivity_of(level, connections, SolverTuning().diagonal_share)),
              boundary_forms<D>(level, bracket.solid(), 10)};
  }

  double energy_of(const Frames& frames) const { return graph_energy(graph_, state_of<D>(frames)); }
  Frames random(std::uint64_t seed) const { return random_frames(graph_.size(), seed); }
  Frames good() const { return settled(graph_, random(1), {60, 1.6, 1e-6, 0}, ignore).frames; }

  FieldGraph<D> graph_;
};
TYPED_TEST_SUITE(Stages, BothDegrees);

TYPED_TEST(Stages, SettledKnowsItsEnergy) {
  for (const int sweeps : {0, 1, 7, 60}) {
    const SettledFrames result = settled(this->graph_, this->random(2), {sweeps, 1.6, 0, 0}, ignore);
    const double expected = this->energy_of(result.frames);
    EXPECT_NEAR(result.energy, expected, kStored * this->energy_of(this->random(2)));
  }
}

TYPED_TEST(Stages, SettledTellsWhetherTheSweepsRanOut) {
  EXPECT_FALSE(settled(this->graph_, this->random(2), {2, 1, 1e-9, 0}, ignore).settled);
  const SettledFrames result = settled(this->graph_, this->random(2), {1000, 1, 1e-3, 0}, ignore);
  EXPECT_TRUE(result.settled);
  const SettledFrames more = settled(this->graph_, result.frames, {1, 1, 0, 0}, ignore);
  EXPECT_LT(result.energy - more.energy, 1e-3 * result.energy);
}

TYPED_TEST(Stages, SettledGoesOnBelowTheEnergyOfACalmField) {
  SettlingPlan plan{2, 1.6, 1e-4, 0};
  const SettledFrames short_of = settled(this->graph_, this->random(2), plan, ignore);
  ASSERT_FALSE(short_of.settled);
  plan.more_sweeps = 1000;
  plan.calm_over_relaxation = 1.6;
  EXPECT_TRUE(same_bits(settled(this->graph_, this->random(2), plan, ignore).frames, short_of.frames));
  plan.calm_energy = 2 * short_of.energy;
  const SettledFrames calm = settled(this->graph_, this->random(2), plan, ignore);
  EXPECT_TRUE(calm.settled);
  EXPECT_TRUE(
      same_bits(calm.frames, settled(this->graph_, this->random(2), {1000, 1.6, 1e-4, 0}, ignore).frames));
}

TYPED_TEST(Stages, ADecreaseIsComparedWithNoLessThanTheLeastEnergy) {
  const Frames start = this->good();
  SettlingPlan plan{1, 1.6, 1e-9, 0};
  ASSERT_FALSE(settled(this->graph_, start, plan, ignore).settled);
  plan.least_energy = 1e9 * this->energy_of(start);
  EXPECT_TRUE(settled(this->graph_, start, plan, ignore).settled);
}

TYPED_TEST(Stages, SettledTellsTheEnergyAfterEverySweep) {
  std::vector<double> energies;
  const SettledFrames result = settled(this->graph_, this->random(2), {12, 1.6, 0, 0},
                                       [&](double energy) { energies.push_back(energy); });
  EXPECT_EQ(energies.size(), 12u);
  EXPECT_TRUE(std::is_sorted(energies.rbegin(), energies.rend()));
  if (TypeParam::value == 4) {
    EXPECT_EQ(energies.back(), result.energy);
  } else {
    EXPECT_GE(energies.back(), result.energy);  // sweeps tell an upper bound
  }
}

TYPED_TEST(Stages, BlocksThatHaveSettledAreLeftAloneWithoutLosingEnergy) {
  const Adjacency& adjacency = this->graph_.adjacency();
  const std::vector<std::uint8_t> colours = testing::colours_of(greedy_colouring(adjacency));
  auto blocked = this->graph_;
  blocked.connectivity = std::make_shared<const Connectivity>(
      Connectivity{adjacency, SweepOrder(adjacency, colours, 64, whole_share(adjacency.size()))});
  auto unaware = blocked;
  SweepOrder order = blocked.order();
  order.blocks_beside.clear();  // so that all are visited in every sweep
  unaware.connectivity = std::make_shared<const Connectivity>(Connectivity{adjacency, order});
  const SettlingPlan plan{200, 1.4, 1e-4, 0};
  const SettledFrames some = settled(blocked, this->good(), plan, ignore);
  const SettledFrames all = settled(unaware, this->good(), plan, ignore);
  EXPECT_TRUE(some.settled);
  EXPECT_NEAR(some.energy / all.energy, 1, 1e-3);
}

TYPED_TEST(Stages, RelaxationThatDoesHarmIsUndone) {
  const Frames start = this->good();
  for (const int sweeps : {0, 1, 3}) {
    const SettlingPlan plan{sweeps, 1.6, 0, 0};
    // Few sweeps from random frames do not come near the start: the claim has something to hold against.
    ASSERT_GT(settled(this->graph_, this->random(9), plan, ignore).energy, 1.5 * this->energy_of(start));
    const SettledFrames result = lower_settled(this->graph_, this->random(9), start, plan, ignore);
    EXPECT_LE(this->energy_of(result.frames), this->energy_of(start) * (1 + kStored));
    EXPECT_TRUE(same_bits(result.frames, settled(this->graph_, start, plan, ignore).frames));
  }
}

TYPED_TEST(Stages, RelaxationThatHelpsIsKept) {
  const Frames better = this->good();
  const SettlingPlan plan{2, 1.6, 0, 0};
  const SettledFrames result = lower_settled(this->graph_, better, this->random(3), plan, ignore);
  EXPECT_TRUE(same_bits(result.frames, settled(this->graph_, better, plan, ignore).frames));
}

TYPED_TEST(Stages, RelaxingAndSettlingNeverEndsAboveWhereItBegan) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    // From poor frames to those that nothing but noise can be gained on.
    for (const int sweeps_before : {0, 5, 100}) {
      const Frames start =
          settled(this->graph_, this->random(seed), {sweeps_before, 1.6, 0, 0}, ignore).frames;
      const SettledFrames result = lower_settled(
          this->graph_, relaxed(this->graph_, start, {4, 4, 1.6}, ignore), start, {40, 1.6, 1e-4, 0}, ignore);
      EXPECT_LE(this->energy_of(result.frames), this->energy_of(start) * (1 + kStored));
    }
  }
}

TYPED_TEST(Stages, RelaxingByNoSweepGivesTheSameFrames) {
  const Frames start = this->random(4);
  const Frames same = relaxed(this->graph_, start, {0, 4, 1.6}, ignore);
  for (std::size_t i = 0; i < start.size(); ++i) {
    // Acos of a cosine in single precision.
    ASSERT_LT(testing::misorientation_rad(from_stored(start[i]), from_stored(same[i])), 1e-3);
  }
}

}  // namespace
}  // namespace crossgrain
