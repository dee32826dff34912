// SPDX-License-Identifier: Apache-2.0
// Graphs for tests of sweeps.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "constraint/normal_form.hpp"
#include "field/connected_level.hpp"
#include "field/octree_graph.hpp"
#include "field/solve_tuning.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain::testing {

// States are stored in single precision, energies are sums of a few thousand terms of either sign.
inline constexpr double kStored = 2e-6;

template <int D>
FieldGraph<D> graph_of(const GridLevel& level, const Solid& solid) {
  const LeafConnections connections = connect_leaves(level, solid);
  return {std::make_shared<const Connectivity>(
              connectivity_of(level, connections, SolverTuning().diagonal_share)),
          boundary_forms<D>(level, solid, 10)};
}

/// A few cells all of which neighbour each other; plane forms on some, general ones on others.
template <int D>
FieldGraph<D> small_graph(RandomSamples& random) {
  constexpr std::uint32_t kCells = 7;
  std::vector<WeightedEdge> edges;
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t j = i + 1; j < kCells; ++j)
      edges.push_back({i, j, static_cast<float>(random.uniform(0.1, 1))});
  }
  const std::vector<std::uint8_t> colours{0, 1, 2, 3, 4, 5, 6};
  FieldGraph<D> graph{
      std::make_shared<const Connectivity>(Connectivity{Adjacency(kCells, edges), colouring_of(colours)}),
      CellForms<D>(kCells)};
  const std::vector<std::uint32_t> general{2, 3};
  graph.forms.set_plane(0, random.direction(), random.uniform(0.5, 5));
  graph.forms.set_plane(1, random.direction(), random.uniform(0.5, 5));
  graph.forms.reserve_general(general);
  for (const std::uint32_t cell : general) {
    QuadraticForm<D> form;
    for (int n = 0; n < 3; ++n) add_normal(form, random.direction(), random.uniform(0.5, 2));
    graph.forms.set_general(cell, form, 1.5);
  }
  return graph;
}

}  // namespace crossgrain::testing
