// SPDX-License-Identifier: Apache-2.0
// One cell, one sweep: local energies, Newton steps, manifold sweeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/parallel.hpp"
#include "constraint/frame_form.hpp"
#include "field/energy.hpp"
#include "field/local_energy.hpp"
#include "field/relaxation.hpp"
#include "field/swept_graphs.hpp"
#include "field/whole_sweep.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::BothDegrees;
using testing::graph_of;
using testing::kStored;
using testing::RandomSamples;
using testing::small_graph;
using testing::TestSolid;
using testing::whole_sweep;

/// A graph of one cell with a form that a single frame meets.
template <int D>
FieldGraph<D> one_cell_graph(const Quaternion& wanted) {
  FieldGraph<D> graph{
      std::make_shared<const Connectivity>(Connectivity{Adjacency(1, std::vector<WeightedEdge>{}),
                                                        colouring_of(std::vector<std::uint8_t>{0})}),
      CellForms<D>(1)};
  QuadraticForm<D> form;
  add_frame(form, wanted, 2);
  graph.forms.reserve_general(std::vector<std::uint32_t>{0});
  graph.forms.set_general(0, form, 1);
  return graph;
}

template <class Degree>
class SweepTest : public ::testing::Test {
 protected:
  const TestSolid bracket_{make_bracket(16)};
  const GridLevel level_ = bracket_.level(0.08);
};
TYPED_TEST_SUITE(SweepTest, BothDegrees);

/// What the bound of degree 3 leaves out when a cell goes from h0 to h: (5/6) sum w_j (h_j.(h -
/// h0))^2.
double left_out(const FieldGraph<3>& graph, const FieldState<3>& state, std::size_t cell,
                const Coefficients<3>& h0, const Coefficients<3>& h) {
  double sum = 0;
  for (const Adjacency::Neighbour& neighbour : graph.adjacency()[cell]) {
    const double change = dot(from_stored<3>(state.coefficients[neighbour.cell]), difference(h, h0));
    sum += 5.0 / 6 * neighbour.weight * change * change;
  }
  return sum;
}
double left_out(const FieldGraph<4>&, const FieldState<4>&, std::size_t, const Coefficients<4>&,
                const Coefficients<4>&) {
  return 0;
}

TYPED_TEST(SweepTest, BoundOfTheLocalEnergyChangesAsTheEnergyOfTheGraphDoesButForWhatItLeavesOut) {
  constexpr int D = TypeParam::value;
  RandomSamples random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const FieldGraph<D> graph = small_graph<D>(random);
    FieldState<D> state = state_of<D>(random_frames(graph.size(), static_cast<std::uint64_t>(trial)));
    for (std::size_t cell = 0; cell < graph.size(); ++cell) {
      const std::array one{static_cast<std::uint32_t>(cell)};
      const LocalEnergy<D, Lanes<2>> local(graph, state.coefficients, {one, 0}, NeighbourTerm::kBound);
      const double before = graph_energy(graph, state);
      const Coefficients<D> h = from_stored<D>(state.coefficients[cell]);
      state.coefficients[cell] = to_stored<D>(frame_coefficients<D>(random.rotation()));
      const Coefficients<D> turned = from_stored<D>(state.coefficients[cell]);
      const double change = graph_energy(graph, state) - before;
      const auto value = [&](const Coefficients<D>& x) {
        Coefficients<D, Lanes<2>> in_both;
        std::copy(x.begin(), x.end(), in_both.begin());
        return local.value(in_both)[0];
      };
      ASSERT_NEAR(value(turned) - value(h), change + left_out(graph, state, cell, h, turned),
                  kStored * before)
          << "cell " << cell;
    }
  }
}

TEST(LocalEnergyOfDegreeThree, IsThatOfTheGraphWhereNeighboursDisagree) {
  RandomSamples random(15);
  const FieldGraph<3> graph = small_graph<3>(random);
  FieldState<3> state = state_of<3>(random_frames(graph.size(), 15));
  const std::array<std::uint32_t, 1> one{0};
  const LocalEnergy<3, Lanes<2>> local(graph, state.coefficients, {one, 0});
  const double before = graph_energy(graph, state);
  const auto value = [&] {
    Coefficients<3, Lanes<2>> in_both;
    for (int m = 0; m < kCoefficientCount<3>; ++m) in_both[m] = state.coefficients[0][m];
    return local.value(in_both)[0];
  };
  const double value_before = value();
  state.coefficients[0] = to_stored<3>(frame_coefficients<3>(random.rotation()));
  EXPECT_NEAR(value() - value_before, graph_energy(graph, state) - before, kStored * before);
}

TEST(LocalEnergyOfDegreeThree, IsThatOfTheGraphToThirdOrderWhereNeighboursAgree) {
  RandomSamples random(14);
  const Vector3 axis = random.direction();
  const Quaternion frame = random.rotation();
  const Coefficients<3> h0 = frame_coefficients<3>(frame);
  const auto left_out_of = [&](double turn_rad) {
    // A neighbour turned as little as the step.
    const Coefficients<3> h = frame_coefficients<3>(from_rotation_vector(turn_rad * axis) * frame);
    const Coefficients<3> neighbour = frame_coefficients<3>(from_rotation_vector(-turn_rad * axis) * frame);
    const double change = dot(neighbour, difference(h, h0));
    return change * change;
  };
  EXPECT_NEAR(left_out_of(0.01) / left_out_of(0.02), 1.0 / 16, 1e-3);
}

TYPED_TEST(SweepTest, NewtonStepSquaresTheDistanceToTheMinimiser) {
  constexpr int D = TypeParam::value;
  RandomSamples random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const Quaternion wanted = random.rotation();
    const FieldGraph<D> graph = one_cell_graph<D>(wanted);
    const double error_rad = 0.05;
    const Quaternion start = from_rotation_vector(error_rad * random.direction()) * wanted;
    FieldState<D> state = state_of<D>({to_stored(start)});
    whole_sweep(graph, state);
    const double after_one = testing::misorientation_rad(from_stored(state.frames[0]), wanted);
    EXPECT_LT(after_one, 2 * error_rad * error_rad);
    whole_sweep(graph, state);
    whole_sweep(graph, state);
    // What single precision resolves; the square root in the angle of near quaternions costs half the digits.
    EXPECT_LT(testing::misorientation_rad(from_stored(state.frames[0]), wanted), 5e-6);
  }
}

TYPED_TEST(SweepTest, ManifoldSweepsFindTheFormsFrameFromAnywhere) {
  constexpr int D = TypeParam::value;
  RandomSamples random(3);
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const Quaternion wanted = random.rotation();
    const FieldGraph<D> graph = one_cell_graph<D>(wanted);
    FieldState<D> state = state_of<D>({to_stored(random.rotation())});
    for (int sweep = 0; sweep < 20; ++sweep) whole_sweep(graph, state);
    found += testing::misorientation_rad(from_stored(state.frames[0]), wanted) < 1e-4;
  }
  // |h(R) - h(S)| has no local minimum but S in degree 4; a start near a maximum may need more sweeps.
  EXPECT_GE(found, 95);
}

TYPED_TEST(SweepTest, ManifoldSweepNeverRaisesTheEnergyHoweverOverRelaxed) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  for (const double over_relaxation : {1.0, 1.6, 1.95}) {
    FieldState<D> state = state_of<D>(random_frames(graph.size(), 4));
    double energy = graph_energy(graph, state);
    const double first = energy;
    for (int sweep = 0; sweep < 30; ++sweep) {
      whole_sweep(graph, state, over_relaxation);
      const double next = graph_energy(graph, state);
      ASSERT_LE(next, energy * (1 + kStored)) << over_relaxation;
      energy = next;
    }
    EXPECT_LT(energy, 0.5 * first);
  }
}

/// A bar of 3 x 3 x 24 cells in which the frames of one end are held turned against those of the other: the
/// minimum is a uniform twist, and it takes many sweeps to reach from one end to the other.
template <int D>
FieldGraph<D> twisted_bar() {
  constexpr std::uint32_t kAcross = 3, kAlong = 24;
  const auto at = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return x + kAcross * (y + kAcross * z);
  };
  std::vector<WeightedEdge> edges;
  std::vector<std::uint32_t> held;
  for (std::uint32_t z = 0; z < kAlong; ++z) {
    for (std::uint32_t y = 0; y < kAcross; ++y) {
      for (std::uint32_t x = 0; x < kAcross; ++x) {
        if (x + 1 < kAcross) edges.push_back({at(x, y, z), at(x + 1, y, z), 1});
        if (y + 1 < kAcross) edges.push_back({at(x, y, z), at(x, y + 1, z), 1});
        if (z + 1 < kAlong) edges.push_back({at(x, y, z), at(x, y, z + 1), 1});
        if (z == 0 || z + 1 == kAlong) held.push_back(at(x, y, z));
      }
    }
  }
  const Adjacency adjacency(kAcross * kAcross * kAlong, edges);
  FieldGraph<D> graph{
      std::make_shared<const Connectivity>(Connectivity{adjacency, greedy_colouring(adjacency)}),
      CellForms<D>(adjacency.size())};
  graph.forms.reserve_general(held);
  for (const std::uint32_t cell : held) {
    QuadraticForm<D> form;
    add_frame(form, from_rotation_vector({0, 0, cell == held.front() || cell < 9 ? 0.0 : 0.7}), 1);
    graph.forms.set_general(cell, form, 20);
  }
  return graph;
}

TYPED_TEST(SweepTest, OverRelaxationReachesTheSameMinimumInAThirdOfTheSweeps) {
  constexpr int D = TypeParam::value;
  const FieldGraph<D> graph = twisted_bar<D>();
  const std::vector<StoredQuaternion> start(graph.size(), to_stored(Quaternion{}));
  FieldState<D> best = state_of<D>(start);
  for (int sweep = 0; sweep < 3000; ++sweep) whole_sweep(graph, best);
  const double minimum = graph_energy(graph, best);
  const auto sweeps_to_the_minimum = [&](double over_relaxation) {
    FieldState<D> state = state_of<D>(start);
    int sweeps = 0;
    while (graph_energy(graph, state) > 1.001 * minimum && sweeps < 3000) {
      whole_sweep(graph, state, over_relaxation);
      ++sweeps;
    }
    return sweeps;
  };
  const int plain = sweeps_to_the_minimum(1);
  EXPECT_GT(plain, 50);
  EXPECT_LT(3 * sweeps_to_the_minimum(1.6), plain);
}

TYPED_TEST(SweepTest, ManifoldSweepReportsByHowMuchTheEnergyFell) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  FieldState<D> state = state_of<D>(random_frames(graph.size(), 5));
  for (int sweep = 0; sweep < 5; ++sweep) {
    const double before = graph_energy(graph, state);
    const double decrease = whole_sweep(graph, state);
    const double fell = before - graph_energy(graph, state);
    EXPECT_GT(fell, decrease - kStored * before);
    // Degree 3 knows a lower bound only, far from it while neighbours still disagree.
    EXPECT_LT(fell, (D == 3 ? 1.2 * decrease : decrease) + kStored * before);
  }
}

TYPED_TEST(SweepTest, ManifoldSweepKeepsCoefficientsThoseOfTheFrames) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  FieldState<D> state = state_of<D>(random_frames(graph.size(), 6));
  whole_sweep(graph, state);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const auto h = frame_coefficients<D>(from_stored(state.frames[i]));
    // A dozen roundings in single precision.
    ASSERT_LT(testing::largest_difference(h, from_stored<D>(state.coefficients[i])), 3e-6);
  }
}

TYPED_TEST(SweepTest, CellsThatAllMoveRestInNoSweep) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  FieldState<D> state = state_of<D>(random_frames(graph.size(), 7)), with_rests = state;
  std::vector<std::uint8_t> awake(graph.size(), 1);
  for (int sweep = 0; sweep < 3; ++sweep) {
    EXPECT_EQ(manifold_sweep(graph, state, 1.4), manifold_sweep(graph, with_rests, 1.4, {{}, awake, 0}));
  }
  EXPECT_EQ(state.coefficients, with_rests.coefficients);
}

TYPED_TEST(SweepTest, RestEndsBesideACellThatMovesEnough) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  FieldState<D> state = state_of<D>(random_frames(graph.size(), 7));
  for (const double least : {0.0, 1e300}) {
    std::vector<std::uint8_t> awake(graph.size(), 0);
    const std::uint32_t first = graph.order().cells.back();  // none is visited after it
    awake[first] = 1;
    const auto before = state.coefficients;
    const auto decreases = manifold_sweep(graph, state, 1.4, {{}, awake, least});
    for (std::uint32_t i = 0; i < graph.size(); ++i)
      ASSERT_EQ(state.coefficients[i] == before[i], i != first);
    std::vector<std::uint8_t> expected(graph.size(), 0);
    if (least == 0) {
      expected[first] = 1;
      for (const auto& [cell, weight] : graph.adjacency()[first]) expected[cell] = 1;
    }
    EXPECT_EQ(awake, expected);
    EXPECT_GT(std::accumulate(decreases.begin(), decreases.end(), 0.0), 0);
    state = state_of<D>(random_frames(graph.size(), 8));
  }
}

TYPED_TEST(SweepTest, SweepsWithRestsAreTheSameToTheBitForAnyNumberOfThreads) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  std::vector<FieldState<D>> results;
  std::vector<std::size_t> resting;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    FieldState<D> state = state_of<D>(random_frames(graph.size(), 7));
    std::vector<std::uint8_t> awake(graph.size(), 1);
    for (int sweep = 0; sweep < 12; ++sweep) manifold_sweep(graph, state, 1.4, {{}, awake, 1e-3});
    results.push_back(std::move(state));
    resting.push_back(static_cast<std::size_t>(std::count(awake.begin(), awake.end(), 0)));
  }
  EXPECT_EQ(results[0].coefficients, results[1].coefficients);
  EXPECT_EQ(results[0].coefficients, results[2].coefficients);
  EXPECT_GT(resting[0], 100u);
  EXPECT_LT(resting[0], results[0].size());
}

TYPED_TEST(SweepTest, SweepsAreTheSameToTheBitForAnyNumberOfThreads) {
  constexpr int D = TypeParam::value;
  const auto graph = graph_of<D>(this->level_, this->bracket_.solid());
  std::vector<FieldState<D>> results;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    FieldState<D> state = state_of<D>(random_frames(graph.size(), 7));
    for (int sweep = 0; sweep < 3; ++sweep) relaxation_sweep(graph, state, 0.5);
    project_to_frames(state);
    for (int sweep = 0; sweep < 3; ++sweep) whole_sweep(graph, state);
    results.push_back(std::move(state));
  }
  EXPECT_EQ(results[0].coefficients, results[1].coefficients);
  EXPECT_EQ(results[0].coefficients, results[2].coefficients);
}

}  // namespace
}  // namespace crossgrain
