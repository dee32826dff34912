// SPDX-License-Identifier: Apache-2.0
#include "field/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/parallel.hpp"
#include "field/energy.hpp"
#include "field/manifold_sweep.hpp"
#include "field/relaxation.hpp"

namespace crossgrain {

template <int D>
std::vector<StoredQuaternion> relaxed(const FieldGraph<D>& graph, std::vector<StoredQuaternion> frames,
                                      const RelaxationPlan& plan, const SweepMonitor& after_sweep) {
  FieldState<D> state = state_of<D>(std::move(frames));
  for (int sweep = 0; sweep < plan.sweeps; ++sweep) {
    const double grown = plan.grows ? (sweep + 1.0) / plan.sweeps : 1;
    relaxation_sweep(graph, state, plan.symmetrisation * grown, plan.over_relaxation, plan.penalty_shares);
    after_sweep(std::numeric_limits<double>::quiet_NaN());
  }
  project_to_frames(state);
  graph.halo().refresh(std::span(state.frames));
  return std::move(state.frames);
}

namespace {

/// Blocks that a sweep still visits: those whose energy the last sweep lowered by more than their share of
/// the allowance, and those beside a block that changed much more, such as one that an arc is about to leave.
class BlocksAwake {
 public:
  explicit BlocksAwake(const SweepOrder& order) : order_(order) {
    if (!order.blocks_beside.empty()) awake_.assign(order.block_count(), 1);
  }

  /// Empty if all blocks are awake.
  std::span<const std::uint8_t> awake() const { return awake_; }

  /// `decreases` are those of the blocks of all processes; `allowance` is the decrease of the energy below
  /// which a sweep is the last.
  void update(const std::vector<double>& decreases, double allowance) {
    const double share = allowance / static_cast<double>(decreases.size());
    for (std::size_t block = 0; block < awake_.size(); ++block) {
      const auto& beside = order_.of_all.blocks_beside[block];
      awake_[block] = decreases[order_.of_all.places[block]] > share ||
                      std::any_of(beside.begin(), beside.end(), [&](std::uint32_t other) {
                        return decreases[other] > kWakesNeighbours * share;
                      });
    }
  }

 private:
  static constexpr double kWakesNeighbours = 10;

  const SweepOrder& order_;
  std::vector<std::uint8_t> awake_;
};

/// Returns the decreases of the blocks of all processes, phase by phase.
std::vector<double> decreases_of_all(const Share& share, const SweepOrder& order, std::vector<double> mine) {
  if (share.is_whole()) return mine;  // orders of small levels have no places
  struct Decrease {
    std::size_t place;
    double amount;
  };
  std::vector<Decrease> placed;
  for (std::size_t block = 0; block < mine.size(); ++block)
    placed.push_back({order.of_all.places[block], mine[block]});
  std::vector<double> all(order.of_all.block_count());
  for (const auto& [place, amount] : of_all(share, std::move(placed))) all[place] = amount;
  return all;
}

template <class T>
LeafValues values_of(std::vector<T>& values) {
  return {std::as_writable_bytes(std::span(values)), sizeof(T)};
}

/// Below the energy of a turn by this angle, sweeps that run out are followed by more with this
/// over-relaxation, which is better for errors that span the part (docs/notes/solver.md).
constexpr double kCalmTurnDeg = 30, kCalmOverRelaxation = 1.9;

}  // namespace

template <int D>
SettledFrames settled(const FieldGraph<D>& graph, std::vector<StoredQuaternion> frames,
                      const SettlingPlan& plan, const SweepMonitor& after_sweep) {
  FieldState<D> state = state_of<D>(std::move(frames));
  const Share share = graph.share();
  SettledFrames result;
  result.energy = graph_energy(graph, state);
  BlocksAwake blocks(graph.order());
  std::vector<std::uint8_t> awake(plan.resting_share > 0 ? state.size() : 0, 0);
  // Ghosts are awake only until their owners have heard of it.
  if (!awake.empty()) std::fill(awake.begin() + share.begin, awake.begin() + share.end, 1);
  // If all frames agree, rounding of the forms makes the energy slightly negative.
  const auto allowance = [&] {
    return plan.fraction * std::max(plan.least_energy, result.energy) + plan.noise;
  };
  const auto sweeps_allowed = [&] {
    return plan.most_sweeps + (result.energy < plan.calm_energy ? plan.more_sweeps : 0);
  };
  int sweep = 0;
  std::vector<LeafValues> lists{values_of(state.frames), values_of(state.coefficients)};
  if (plan.resting_share > 0) lists.push_back(values_of(awake));
  if (plan.keeper != nullptr) {
    if (const auto before = plan.keeper->resumed(lists)) {
      sweep = result.sweeps_before = before->sweeps;
      result.energy = before->energy;
      blocks.update(before->decreases, allowance());
      graph.halo().refresh(std::span(state.coefficients));
    }
  }
  for (; sweep < sweeps_allowed() && !result.settled; ++sweep) {
    const double over_relaxation =
        sweep < plan.most_sweeps ? plan.over_relaxation : plan.calm_over_relaxation;
    const double least_decrease = plan.resting_share * allowance() / static_cast<double>(share.of_all);
    const std::vector<double> decreases = decreases_of_all(
        share, graph.order(),
        manifold_sweep(graph, state, over_relaxation, {blocks.awake(), awake, least_decrease}));
    const double decrease = std::accumulate(decreases.begin(), decreases.end(), 0.0);
    result.energy -= decrease;
    after_sweep(result.energy);
    // In degree 3 sweeps return a lower bound of the decrease.
    result.settled = decrease <= (1 - plan.resting_share) * allowance();
    if (D == 3 && (result.settled || sweep + 1 >= sweeps_allowed()))
      result.energy = graph_energy(graph, state);
    blocks.update(decreases, allowance());
    if (plan.keeper != nullptr && !result.settled && plan.keeper->is_due())
      plan.keeper->keep({sweep + 1, result.energy, decreases}, lists);
  }
  graph.halo().refresh(std::span(state.frames));
  result.frames = std::move(state.frames);
  return result;
}

template <class Options>
SettlingPlan settling_plan(const Options& options, const Connectivity& connectivity, double volume,
                           double side) {
  const CalmFieldTuning& calm = options.calm_fields;
  const auto energy_of_turn = [&](double angle_deg) {
    const double turn = angle_deg * std::numbers::pi / 180;
    return 5.0 / 3 * turn * turn * volume / (side * side);
  };
  return {options.most_sweeps,
          options.over_relaxation,
          options.sweep_tolerance,
          rounding_noise(connectivity.adjacency, connectivity.share()),
          kRestingShare,
          energy_of_turn(calm.least_turn_deg),
          energy_of_turn(kCalmTurnDeg),
          calm.more_sweeps,
          kCalmOverRelaxation,
          nullptr};
}

template SettlingPlan settling_plan(const SolverTuning&, const Connectivity&, double, double);
template SettlingPlan settling_plan(const TetFinishing&, const Connectivity&, double, double);

double rounding_noise(const Adjacency& adjacency, const Share& share) {
  constexpr double kSquaredTurn = 1e-12;
  return kSquaredTurn * parallel_sum(share, [&](std::size_t i) {
           double sum = 0;
           for (const Adjacency::Neighbour& neighbour : adjacency[i]) sum += std::abs(neighbour.weight);
           return sum;
         });
}

template std::vector<StoredQuaternion> relaxed<3>(const FieldGraph<3>&, std::vector<StoredQuaternion>,
                                                  const RelaxationPlan&, const SweepMonitor&);
template std::vector<StoredQuaternion> relaxed<4>(const FieldGraph<4>&, std::vector<StoredQuaternion>,
                                                  const RelaxationPlan&, const SweepMonitor&);
template SettledFrames settled<3>(const FieldGraph<3>&, std::vector<StoredQuaternion>, const SettlingPlan&,
                                  const SweepMonitor&);
template SettledFrames settled<4>(const FieldGraph<4>&, std::vector<StoredQuaternion>, const SettlingPlan&,
                                  const SweepMonitor&);

}  // namespace crossgrain
