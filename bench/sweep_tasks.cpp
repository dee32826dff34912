// SPDX-License-Identifier: Apache-2.0
// Simulates sweeps on many threads from the blocks of real levels (docs/notes/performance.md): phases as
// barriers, and blocks that wait only for blocks beside them. The seconds of each block are measured on one
// thread.
//
//   sweep_tasks RESOLUTION...
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/thread_limit.hpp"
#include "field/leaf_stencil.hpp"
#include "field/manifold_sweep.hpp"
#include "field/octree_graph.hpp"
#include "field/solve_tuning.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr int kCoarsestDepth = 4;

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The graph of the finest level at a resolution; refinement by energy density is left out.
FieldGraph<4> graph_of(const testing::TestSolid& part, int resolution) {
  const SolverTuning options;
  const Solid& solid = part.solid();
  const GridFrame frame = frame_around(part.surface().box, longest_side(part.surface().box) / resolution);
  RefinedLevel made = uniform_level(solid, frame.root, kCoarsestDepth);
  for (int depth = kCoarsestDepth; depth < frame.finest_depth; ++depth)
    made = refined(made.level, made.neighbours, solid,
                   refinement_marks(made.level, made.neighbours, solid, {}, 0, frame.finest_depth));
  const LeafConnections connections = connect_leaves(made.level, made.neighbours, solid);
  return {std::make_shared<const Connectivity>(
              connectivity_of(made.level, made.neighbours, connections, options.diagonal_share)),
          boundary_forms<4>(made.level, solid, options.boundary_weight)};
}

/// The seconds of each block in a sweep of its own, the others being asleep, less those of a sweep asleep.
std::vector<double> seconds_of_blocks(const FieldGraph<4>& graph) {
  const ThreadLimit one_thread(1);
  FieldState<4> state = state_of<4>(random_frames(graph.size(), 1));
  std::vector<std::uint8_t> awake(graph.order().block_count(), 0);
  const auto sweep = [&] { manifold_sweep(graph, state, 1.4, {awake, {}, 0}); };
  double idle = seconds_of(sweep);
  for (int i = 0; i < 20; ++i) idle = std::min(idle, seconds_of(sweep));
  std::vector<double> seconds(awake.size());
  for (std::size_t block = 0; block < awake.size(); ++block) {
    awake[block] = 1;
    seconds[block] = std::max(0.0, std::min(seconds_of(sweep), seconds_of(sweep)) - idle);
    awake[block] = 0;
  }
  return seconds;
}

/// Returns the time until all blocks [begin, end) are done on so many threads, each of which takes the lowest
/// block that may begin. `waits(b)` is the number of blocks before b, and those that `after(b)` lists wait
/// for b.
double simulated(std::size_t begin, std::size_t end, int threads, const std::vector<double>& seconds,
                 std::vector<std::size_t> waits,
                 const std::function<std::vector<std::uint32_t>(std::size_t)>& after) {
  using End = std::pair<double, std::size_t>;
  std::priority_queue<End, std::vector<End>, std::greater<>> running;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready;
  for (std::size_t b = begin; b < end; ++b)
    if (waits[b] == 0) ready.push(b);
  double now = 0;
  while (!ready.empty() || !running.empty()) {
    while (!ready.empty() && running.size() < static_cast<std::size_t>(threads)) {
      running.emplace(now + seconds[ready.top()], ready.top());
      ready.pop();
    }
    const auto [ended, block] = running.top();
    running.pop();
    now = ended;
    for (const std::uint32_t other : after(block))
      if (--waits[other] == 0) ready.push(other);
  }
  return now;
}

double simulated_phases(const SweepOrder& order, int threads, const std::vector<double>& seconds) {
  double total = 0;
  for (std::size_t p = 0; p < order.phase_count(); ++p)
    total += simulated(order.phase_begin[p], order.phase_begin[p + 1], threads, seconds,
                       std::vector<std::size_t>(seconds.size()),
                       [](std::size_t) { return std::vector<std::uint32_t>{}; });
  return total;
}

double simulated_tasks(const SweepOrder& order, int threads, const std::vector<double>& seconds) {
  const auto& beside = order.blocks_beside;
  std::vector<std::size_t> waits(beside.size());
  for (std::size_t b = 0; b < beside.size(); ++b)
    waits[b] = static_cast<std::size_t>(
        std::count_if(beside[b].begin(), beside[b].end(), [&](std::uint32_t other) { return other < b; }));
  return simulated(0, seconds.size(), threads, seconds, std::move(waits), [&](std::size_t block) {
    std::vector<std::uint32_t> later;
    std::copy_if(beside[block].begin(), beside[block].end(), std::back_inserter(later),
                 [&](std::uint32_t other) { return other > block; });
    return later;
  });
}

void table_rows(const std::string& name, const testing::TestSolid& part, int resolution) {
  const FieldGraph<4> graph = graph_of(part, resolution);
  const SweepOrder& order = graph.order();
  if (order.blocks_beside.empty()) {
    fmt::print("| {} | {} | too small for blocks |\n", name, graph.size());
    return;
  }
  const std::vector<double> seconds = seconds_of_blocks(graph);
  double all = 0;
  for (const double s : seconds) all += s;
  for (const int threads : {2, 8, 16, 64})
    fmt::print("| {} | {} | {} in {} | {} | {:.3f} | {:.3f} |\n", name, graph.size(), seconds.size(),
               order.phase_count(), threads, all / threads / simulated_phases(order, threads, seconds),
               all / threads / simulated_tasks(order, threads, seconds));
}

}  // namespace
}  // namespace crossgrain

int main(int count, char** arguments) {
  using namespace crossgrain;
  const testing::TestSolid bracket(make_bracket(64)), torus(make_torus(0.6, 0.25, 192, 96));
  fmt::print(
      "| part | cells | blocks in phases | threads | efficiency by phases | by tasks "
      "|\n|---|---|---|---|---|---|\n");
  for (int i = 1; i < count; ++i) {
    table_rows("bracket", bracket, std::atoi(arguments[i]));
    table_rows("torus", torus, std::atoi(arguments[i]));
  }
}
