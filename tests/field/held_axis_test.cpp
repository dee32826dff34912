// SPDX-License-Identifier: Apache-2.0
// Cells that hold an axis, greedy colours, and projection from a cell's own frame.
#include <gtest/gtest.h>

#include "constraint/normal_form.hpp"
#include "field/connected_level.hpp"
#include "field/energy.hpp"
#include "field/leaf_stencil.hpp"
#include "field/octree_graph.hpp"
#include "field/relaxation.hpp"
#include "field/solve_tuning.hpp"
#include "field/whole_sweep.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::connect_leaves;
using testing::connectivity_of;
using testing::RandomSamples;
using testing::TestSolid;
using testing::whole_sweep;

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
  for (int sweep = 0; sweep < 50; ++sweep) whole_sweep(graph, state);
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
  for (int sweep = 0; sweep < 10; ++sweep) whole_sweep(graph, state);
  EXPECT_NEAR(graph_energy(graph, state), 0, 1e-10);
}

/// Every other cell of a random graph holds an axis of its random frame.
struct HeldGraph {
  explicit HeldGraph(unsigned seed) {
    RandomSamples random(seed);
    const Adjacency adjacency(kCells, random_edges(random));
    graph = {std::make_shared<const Connectivity>(Connectivity{adjacency, greedy_colouring(adjacency)}),
             CellForms<4>(kCells)};
    for (std::uint32_t i = 0; i < kCells; ++i) frames.push_back(to_stored(random.rotation()));
    for (std::uint32_t i = 0; i < kCells; i += 2)
      graph.forms.hold_axis(i, axes_of(from_stored(frames[i]))[i % 3]);
  }

  FieldState<4> relaxed(int sweeps, double symmetrisation, double over_relaxation) const {
    FieldState<4> state = state_of<4>(frames);
    for (int sweep = 0; sweep < sweeps; ++sweep)
      relaxation_sweep(graph, state, symmetrisation, over_relaxation);
    return state;
  }

  FieldGraph<4> graph;
  std::vector<StoredQuaternion> frames;
};

/// b_n + x C + y S.
Coefficients<4> coefficients_about(const NormalBasis<4>& basis, double x, double y) {
  Coefficients<4> h = basis.zonal;
  add_scaled(h, x, basis.cosine);
  add_scaled(h, y, basis.sine);
  return h;
}

TEST(RelaxationOfHeldAxes, KeepsTheCoefficientsThoseOfFramesAboutTheAxisButForTheirRadius) {
  const HeldGraph held(7);
  for (const double symmetrisation : {0.0, 0.7, 4.0}) {
    const FieldState<4> state = held.relaxed(10, symmetrisation, 1.6);
    for (std::uint32_t i = 0; i < kCells; i += 2) {
      const NormalBasis<4> basis = normal_basis<4>(*held.graph.forms.held_axis(i));
      const Coefficients<4> h = from_stored<4>(state.coefficients[i]);
      const double x = dot(basis.cosine, h), y = dot(basis.sine, h);
      // What single precision rounds.
      EXPECT_LT(testing::largest_difference(h, coefficients_about(basis, x, y)), 1e-6);
      // With a whole step the penalty takes the radius to that of frames.
      if (symmetrisation >= 1) {
        EXPECT_NEAR(x * x + y * y, 1 - kZonalShare, 1e-6);
      }
    }
  }
}

TEST(RelaxationOfHeldAxes, FindsTheMinimumThatTryingAllRadiiAndAnglesFinds) {
  RandomSamples random(8);
  for (int trial = 0; trial < 20; ++trial) {
    // The highest of a star's cells is visited last: it sees what its neighbours have become.
    constexpr std::uint32_t kCentre = 5;
    std::vector<WeightedEdge> edges;
    for (std::uint32_t i = 0; i < kCentre; ++i)
      edges.push_back({i, kCentre, static_cast<float>(random.uniform(0.1, 1))});
    const Adjacency adjacency(kCentre + 1, edges);
    FieldGraph<4> graph{
        std::make_shared<const Connectivity>(Connectivity{adjacency, greedy_colouring(adjacency)}),
        CellForms<4>(kCentre + 1)};
    FieldState<4> state = state_of<4>(random_frames(kCentre + 1, static_cast<std::uint64_t>(trial)));
    graph.forms.hold_axis(kCentre, axes_of(from_stored(state.frames[kCentre]))[0]);
    // Among neighbours that hold axes too, the centre does not just find what they all have become.
    graph.forms.hold_axis(0, axes_of(from_stored(state.frames[0]))[1]);
    graph.forms.hold_axis(1, axes_of(from_stored(state.frames[1]))[2]);
    relaxation_sweep(graph, state, 0, 1);

    const NormalBasis<4> basis = normal_basis<4>(*graph.forms.held_axis(kCentre));
    const Coefficients<4> found = from_stored<4>(state.coefficients[kCentre]);
    double x = 0, y = 0;
    for (double step = 0.1; step > 5e-4; step /= 10) {
      const double x_before = x, y_before = y;
      double least = INFINITY;
      for (int i = -15; i <= 15; ++i) {
        for (int j = -15; j <= 15; ++j) {
          const double x_tried = x_before + i * step, y_tried = y_before + j * step;
          state.coefficients[kCentre] = to_stored<4>(coefficients_about(basis, x_tried, y_tried));
          const double energy = graph_energy(graph, state);
          if (energy < least) {
            least = energy;
            x = x_tried;
            y = y_tried;
          }
        }
      }
    }
    // The last step, and as much again for energies in single precision.
    EXPECT_NEAR(dot(basis.cosine, found), x, 2e-3);
    EXPECT_NEAR(dot(basis.sine, found), y, 2e-3);
  }
}

TEST(RelaxationOfHeldAxes, EndsAtTheSameFieldHoweverOverRelaxed) {
  const HeldGraph held(9);
  const FieldState<4> plain = held.relaxed(1000, 0, 1);
  for (const double over_relaxation : {1.3, 1.6, 1.9}) {
    const FieldState<4> other = held.relaxed(1000, 0, over_relaxation);
    for (std::size_t i = 0; i < kCells; ++i) {
      EXPECT_LT(testing::largest_difference(from_stored<4>(plain.coefficients[i]),
                                            from_stored<4>(other.coefficients[i])),
                1e-5);
    }
  }
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
  const FieldGraph<D> graph{std::make_shared<const Connectivity>(
                                connectivity_of(level, connections, SolverTuning().diagonal_share)),
                            boundary_forms<D>(level, bracket.solid(), 10)};
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
