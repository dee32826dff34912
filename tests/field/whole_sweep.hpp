// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numeric>
#include <vector>

#include "field/manifold_sweep.hpp"

namespace crossgrain::testing {

/// Sweeps all cells once. Returns the decrease of the energy.
template <int D>
double whole_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double over_relaxation = 1) {
  const std::vector<double> decreases = manifold_sweep(graph, state, over_relaxation);
  return std::accumulate(decreases.begin(), decreases.end(), 0.0);
}

}  // namespace crossgrain::testing
