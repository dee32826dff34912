// SPDX-License-Identifier: Apache-2.0
#include "field/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
    relaxation_sweep(graph, state, plan.symmetrisation * (sweep + 1) / plan.sweeps, plan.over_relaxation);
    after_sweep(std::numeric_limits<double>::quiet_NaN());
  }
  project_to_frames(state);
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

  /// `allowance` is the decrease of the energy below which a sweep is the last.
  void update(const std::vector<double>& decreases, double allowance) {
    const double share = allowance / static_cast<double>(decreases.size());
    for (std::size_t block = 0; block < awake_.size(); ++block) {
      const auto& beside = order_.blocks_beside[block];
      awake_[block] =
          decreases[block] > share || std::any_of(beside.begin(), beside.end(), [&](std::uint32_t other) {
            return decreases[other] > kWakesNeighbours * share;
          });
    }
  }

 private:
  static constexpr double kWakesNeighbours = 10;

  const SweepOrder& order_;
  std::vector<std::uint8_t> awake_;
};

}  // namespace

template <int D>
SettledFrames settled(const FieldGraph<D>& graph, std::vector<StoredQuaternion> frames,
                      const SettlingPlan& plan, const SweepMonitor& after_sweep) {
  FieldState<D> state = state_of<D>(std::move(frames));
  SettledFrames result;
  result.energy = graph_energy(graph, state);
  BlocksAwake blocks(graph.order());
  // If all frames agree, rounding of the forms makes the energy slightly negative.
  const auto allowance = [&] { return plan.fraction * std::max(0.0, result.energy) + plan.noise; };
  for (int sweep = 0; sweep < plan.most_sweeps && !result.settled; ++sweep) {
    const std::vector<double> decreases =
        manifold_sweep_over(graph, state, plan.over_relaxation, blocks.awake());
    const double decrease = std::accumulate(decreases.begin(), decreases.end(), 0.0);
    result.energy -= decrease;
    after_sweep(result.energy);
    // In degree 3 sweeps return a lower bound of the decrease.
    const bool is_last = decrease <= allowance() || sweep + 1 == plan.most_sweeps;
    if (D == 3 && is_last) result.energy = graph_energy(graph, state);
    result.settled = decrease <= allowance();
    blocks.update(decreases, allowance());
  }
  result.frames = std::move(state.frames);
  return result;
}

double rounding_noise(const Adjacency& adjacency) {
  constexpr double kSquaredTurn = 1e-12;
  return kSquaredTurn * parallel_sum(adjacency.size(), [&](std::size_t i) {
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
