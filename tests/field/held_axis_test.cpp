// SPDX-License-Identifier: Apache-2.0
// Cells that hold an axis, greedy colours, and projection from a cell's own frame.
#include <gtest/gtest.h>

#include "field/energy.hpp"
#include "field/manifold_sweep.hpp"
#include "field/octree_graph.hpp"
#include "field/relaxation.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::RandomSamples;
using testing::TestSolid;

constexpr std::uint32_t kCells = 12;

std::vector<WeightedEdge> random_edges(RandomSamples& random) {
  std::vector<WeightedEdge> edges;
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t j = i + 1; j < kCells; ++j) {
      if (random.uniform(0, 1) < 0.4) edges.push_back({i, j, static_cast<float>(random.uniform(0.1, 1))});
    }
  }
  return edges;
}

template <class Degree>
class HeldAxis : public ::testing::Test {};
TYPED_TEST_SUITE(HeldAxis, BothDegrees);

TYPED_TEST(HeldAxis, StaysWhereItIsWhileTheEnergyFalls) {
  constexpr int D = TypeParam::value;
  RandomSamples random(5);
  const Adjacency adjacency(kCells, random_edges(random));
  FieldGraph<D> graph{
      std::make_shared<const Connectivity>(Connectivity{adjacency, greedy_colouring(adjacency)}),
      CellForms<D>(kCells)};
  std::vector<StoredQuaternion> frames;
  for (std::uint32_t i = 0; i < kCells; ++i) frames.push_back(to_stored(random.rotation()));
  for (std::uint32_t i = 0; i < kCells; i += 2) {
    graph.forms.hold_axis(i, axes_of(from_stored(frames[i]))[i % 3]);
  }
  FieldState<D> state = state_of<D>(frames);
  const double before = graph_energy(graph, state);
  for (int sweep = 0; sweep < 50; ++sweep) manifold_sweep(graph, state);
  EXPECT_LT(graph_energy(graph, state), 0.9 * before);
  for (std::uint32_t i = 0; i < kCells; i += 2) {
    const Vector3 kept = axes_of(from_stored(state.frames[i]))[i % 3];
    // Fifty turns, each rounded to single precision.
    EXPECT_LT(norm(cross(kept, *graph.forms.held_axis(i))), 1e-5);
  }
}

TYPED_TEST(HeldAxis, TurnsToTheBestFrameAboutItsAxis) {
  constexpr int D = TypeParam::value;
  const std::vector<WeightedEdge> edges{{0, 1, 1.0f}};
  const Adjacency adjacency(2, edges);
  FieldGraph<D> graph{
      std::make_shared<const Connectivity>(Connectivity{adjacency, greedy_colouring(adjacency)}),
      CellForms<D>(2)};
  graph.forms.hold_axis(0, {0, 0, 1});
  graph.forms.hold_axis(1, {0, 0, 1});
  const Quaternion turned = from_rotation_vector({0, 0, 0.6});
  FieldState<D> state = state_of<D>({to_stored(Quaternion{}), to_stored(turned)});
  for (int sweep = 0; sweep < 10; ++sweep) manifold_sweep(graph, state);
  EXPECT_NEAR(graph_energy(graph, state), 0, 1e-10);
}

TEST(GreedyColouring, GivesNeighboursDifferentColoursAndVisitsEveryCellOnce) {
  RandomSamples random(6);
  const std::vector<WeightedEdge> edges = random_edges(random);
  const Colouring colouring = greedy_colouring(Adjacency(kCells, edges));
  std::vector<int> colour_of(kCells, -1);
  for (std::size_t colour = 0; colour < colouring.colour_count(); ++colour) {
    for (std::size_t k = colouring.begin[colour]; k < colouring.begin[colour + 1]; ++k) {
      EXPECT_EQ(colour_of[colouring.cells[k]], -1);
      colour_of[colouring.cells[k]] = static_cast<int>(colour);
    }
  }
  for (const WeightedEdge& edge : edges) EXPECT_NE(colour_of[edge.first], colour_of[edge.second]);
  EXPECT_EQ(std::count(colour_of.begin(), colour_of.end(), -1), 0);
}

TYPED_TEST(HeldAxis, ProjectionFromTheOwnFrameFindsTheNearestOfAll) {
  constexpr int D = TypeParam::value;
  const TestSolid bracket(make_bracket(16));
  const GridLevel level = bracket.level(0.08);
  const LeafConnections connections = connect_leaves(level, bracket.solid());
  const FieldGraph<D> graph{std::make_shared<const Connectivity>(connectivity_of(level, connections.edges)),
                            boundary_forms<D>(level, bracket.solid(), 10, Shift::kNone)};
  for (const int sweeps : {1, 3, 10, 40}) {
    FieldState<D> state = state_of<D>(random_frames(level.size(), 3));
    for (int sweep = 0; sweep < sweeps; ++sweep) relaxation_sweep(graph, state, 0.5 * (sweep + 1) / sweeps);
    const auto relaxed = state.coefficients;
    project_to_frames(state);
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Coefficients<D> h = from_stored<D>(relaxed[i]);
      const auto overlap = [&](const Quaternion& frame) {
        const double cosine = dot(h, frame_coefficients<D>(frame));
        return (D == 3 ? std::abs(cosine) : cosine) / std::sqrt(squared_norm(h));
      };
      // Frames are stored in single precision.
      EXPECT_GE(overlap(from_stored(state.frames[i])), overlap(nearest_frame<D>(h)) - 1e-6);
    }
  }
}

}  // namespace
}  // namespace crossgrain
