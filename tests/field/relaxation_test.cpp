// SPDX-License-Identifier: Apache-2.0
#include "field/relaxation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "field/energy.hpp"
#include "field/swept_graphs.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::graph_of;
using testing::kStored;
using testing::RandomSamples;
using testing::small_graph;
using testing::TestSolid;

template <class Degree>
class RelaxationTest : public ::testing::Test {
 protected:
  const TestSolid bracket_{make_bracket(16)};
  const GridLevel level_ = bracket_.level(0.08);
};
TYPED_TEST_SUITE(RelaxationTest, BothDegrees);

TYPED_TEST(RelaxationTest, PenaltySharesLieBetweenNoPenaltyAndAllOfIt) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  const auto swept = [&](double symmetrisation, std::span<const float> shares) {
    FieldState<D> state = state_of<D>(random_frames(graph.size(), 7));
    for (int sweep = 0; sweep < 3; ++sweep) relaxation_sweep(graph, state, symmetrisation, 1, shares);
    return state.coefficients;
  };
  const std::vector<float> none(graph.size(), 0), half(graph.size(), 0.5), all(graph.size(), 1);
  EXPECT_EQ(swept(1, all), swept(1, {}));
  EXPECT_EQ(swept(1, half), swept(0.5, {}));
  EXPECT_NE(swept(1, half), swept(1, {}));
  if constexpr (D == 4) {
    EXPECT_EQ(swept(1, none), swept(0, {}));
  }
}

TYPED_TEST(RelaxationTest, RelaxationSweepNeverRaisesTheRelaxedEnergy) {
  constexpr int D = TypeParam::value;
  RandomSamples random(8);
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  FieldState<D> state = state_of<D>(random_frames(graph.size(), 8));
  double energy = graph_energy(graph, state);
  for (int sweep = 0; sweep < 30; ++sweep) {
    relaxation_sweep(graph, state, 0);
    const double next = graph_energy(graph, state);
    ASSERT_LE(next, energy + kStored * std::abs(energy)) << "sweep " << sweep;
    energy = next;
  }
}

TYPED_TEST(RelaxationTest, ProjectionGivesTheNearestFrameAndItsCoefficients) {
  constexpr int D = TypeParam::value;
  RandomSamples random(9);
  FieldState<D> state;
  for (int i = 0; i < 20; ++i) state.coefficients.push_back(to_stored<D>(random.coefficients<D>()));
  const auto relaxed = state.coefficients;
  state.frames.resize(state.coefficients.size());
  project_to_frames(state);
  const auto overlap = [](const Coefficients<D>& a, const Coefficients<D>& b) {
    return D == 3 ? std::abs(dot(a, b)) : dot(a, b);
  };
  for (std::size_t i = 0; i < state.size(); ++i) {
    const Coefficients<D> target = from_stored<D>(relaxed[i]), h = from_stored<D>(state.coefficients[i]);
    EXPECT_LT(deviation<D>(h), 1e-8);
    EXPECT_NEAR(squared_norm(h), 1, 1e-6);
    for (int k = 0; k < 200; ++k)
      ASSERT_GE(overlap(target, h), overlap(target, frame_coefficients<D>(random.rotation())) - 1e-5);
  }
}

TEST(RelaxationInDegreeFour, ForgetsWhereItStarted) {
  const TestSolid sphere(make_sphere(0.5, 3));
  const GridLevel level = sphere.level(0.12);
  const auto graph = graph_of<4>(level, sphere.solid());
  std::vector<FieldState<4>> states;
  for (const std::uint64_t seed : {1, 2}) {
    states.push_back(state_of<4>(random_frames(graph.size(), seed)));
    for (int sweep = 0; sweep < 200; ++sweep) relaxation_sweep(graph, states.back(), 0);
  }
  double largest = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    largest = std::max(largest, testing::largest_difference(from_stored<4>(states[0].coefficients[i]),
                                                            from_stored<4>(states[1].coefficients[i])));
  }
  EXPECT_LT(largest, 1e-4);
}

TEST(RelaxationInDegreeFour, MeetsTheMinimumOfALocalEnergyInOneVisit) {
  RandomSamples random(10);
  for (int trial = 0; trial < 10; ++trial) {
    FieldGraph<4> graph = small_graph<4>(random);
    FieldState<4> state = state_of<4>(random_frames(graph.size(), static_cast<std::uint64_t>(trial)));
    relaxation_sweep(graph, state, 0);
    // The last cell visited sees what the others have become: nothing around it costs less.
    const double least = graph_energy(graph, state);
    const auto h = state.coefficients.back();
    for (int k = 0; k < 50; ++k) {
      Coefficients<4> other = from_stored<4>(h);
      add_scaled(other, 0.05, random.coefficients<4>());
      state.coefficients.back() = to_stored<4>(other);
      ASSERT_GT(graph_energy(graph, state), least);
    }
  }
}

TEST(RelaxationWithSymmetrisation, BringsCoefficientsNearerToFrames) {
  const TestSolid sphere(make_sphere(0.5, 3));
  const GridLevel level = sphere.level(0.1);
  const auto graph = graph_of<4>(level, sphere.solid());
  const auto mean_defect = [&](double symmetrisation) {
    FieldState<4> state = state_of<4>(random_frames(graph.size(), 11));
    for (int sweep = 0; sweep < 100; ++sweep) relaxation_sweep(graph, state, symmetrisation);
    double sum = 0;
    for (const auto& stored : state.coefficients)
      sum += std::abs(1 - std::sqrt(squared_norm(from_stored<4>(stored))));
    return sum / static_cast<double>(state.size());
  };
  EXPECT_LT(mean_defect(1), 0.7 * mean_defect(0));
}

TEST(RelaxationWithSymmetrisation, StaysBoundedUnderOverRelaxationAndNegativeWeights) {
  // As on tets with obtuse angles: a third of the weights is negative, while every sum of weights is
  // positive.
  constexpr std::uint32_t kCount = 60;
  std::vector<WeightedEdge> edges;
  for (std::uint32_t i = 0; i < kCount; ++i) {
    edges.push_back({i, (i + 1) % kCount, 1.0f});
    edges.push_back({i, (i + 7) % kCount, 1.0f});
    edges.push_back({i, (i + 13) % kCount, -1.3f});
  }
  Connectivity connectivity;
  connectivity.adjacency = Adjacency(kCount, edges);
  connectivity.order = greedy_colouring(connectivity.adjacency);
  const FieldGraph<4> graph{std::make_shared<const Connectivity>(std::move(connectivity)),
                            CellForms<4>(kCount)};
  FieldState<4> state = state_of<4>(random_frames(kCount, 9));
  for (int sweep = 0; sweep < 100; ++sweep) relaxation_sweep(graph, state, 6, 1.95);
  for (const auto& stored : state.coefficients) EXPECT_LT(squared_norm(from_stored<4>(stored)), 4);
}

}  // namespace
}  // namespace crossgrain
