// SPDX-License-Identifier: Apache-2.0
// Kernels of the octree and its graph; items are leaves of the finer level.
#include <benchmark/benchmark.h>

#include "field/solve_tuning.hpp"
#include "grid/open_faces.hpp"
#include "kernels/levels.hpp"
#include "kernels/surface_flops.hpp"

namespace crossgrain::bench {
namespace {

/// Bytes: reads the previous level and writes the new one. Flops: clipping and crossings.
template <Part kPart>
void refinement(benchmark::State& state) {
  const PartLevel& part = part_level(kPart);
  const Solid solid = part.solid.solid();
  for (auto _ : state)
    benchmark::DoNotOptimize(refined(part.before, part.neighbours_before, solid, part.marks));
  const auto leaves = static_cast<double>(part.level.size());
  const auto [tried, kept] = clipped_pieces(part);
  const double flops = (tried - kept) * kRejectedClipFlops + kept * kClipFlops + tried * crossing_flops(8);
  report(state, part.level.size(), {flops / leaves, (bytes_of(part.before) + bytes_of(part.level)) / leaves});
}

/// Bytes: reads the level and writes the faces. Flops: samples of open fractions.
template <Part kPart>
void connection(benchmark::State& state) {
  const PartLevel& part = part_level(kPart);
  const Solid solid = part.solid.solid();
  for (auto _ : state) benchmark::DoNotOptimize(connect_leaves(part.level, part.neighbours, solid));
  const auto leaves = static_cast<double>(part.level.size());
  report(state, part.level.size(),
         {sampled_pieces(part) * crossing_flops(kOpenFaceSamples) / leaves,
          (bytes_of(part.level) + bytes_of(part.connections)) / leaves});
}

/// Bytes: reads addresses and faces, writes lists and the order. Flops: only sums of weights.
template <Part kPart>
void adjacency(benchmark::State& state) {
  const PartLevel& part = part_level(kPart);
  const double share = SolverTuning{}.diagonal_share;
  for (auto _ : state)
    benchmark::DoNotOptimize(connectivity_of(part.level, part.neighbours, part.connections, share));
  const auto leaves = static_cast<double>(part.level.size());
  const double lists = bytes_of(part_field<4>(kPart).graph.adjacency());
  report(state, part.level.size(),
         {0, (bytes_of(part.connections) + lists) / leaves + sizeof(CellAddress) + sizeof(CellIndex)});
}

BENCHMARK(refinement<Part::kBracket>)->Name("octree refinement, bracket")->Unit(benchmark::kMillisecond);
BENCHMARK(refinement<Part::kTorus>)->Name("octree refinement, torus")->Unit(benchmark::kMillisecond);
BENCHMARK(connection<Part::kBracket>)->Name("leaf connections, bracket")->Unit(benchmark::kMillisecond);
BENCHMARK(connection<Part::kTorus>)->Name("leaf connections, torus")->Unit(benchmark::kMillisecond);
BENCHMARK(adjacency<Part::kBracket>)
    ->Name("neighbour lists and order, bracket")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace crossgrain::bench
