// SPDX-License-Identifier: Apache-2.0
#include "field/stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

template <int D>
SettledFrames settled(const FieldGraph<D>& graph, std::vector<StoredQuaternion> frames,
                      const SettlingPlan& plan, const SweepMonitor& after_sweep) {
  FieldState<D> state = state_of<D>(std::move(frames));
  SettledFrames result;
  result.energy = graph_energy(graph, state);
  for (int sweep = 0; sweep < plan.most_sweeps && !result.settled; ++sweep) {
    const double decrease = manifold_sweep(graph, state, plan.over_relaxation);
    result.energy -= decrease;
    after_sweep(result.energy);
    // Where all frames agree, rounding of the forms takes the energy a little below nothing.
    result.settled = decrease <= plan.fraction * std::max(0.0, result.energy) + plan.noise;
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
