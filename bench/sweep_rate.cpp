// SPDX-License-Identifier: Apache-2.0
// How fast this machine is, and how much faster our sweep than a plain one: manifold sweeps of degree 4 over
// a box of cells, one thread, the same Newton steps once written plainly in doubles, a cell at a time, and
// once by the library.
//
//   sweep_rate [CELLS ACROSS]      default 48
//
// Prints million cell updates a second of both, the best of five rounds that take turns, and their ratio.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "crossgrain/thread_limit.hpp"
#include "field/manifold_sweep.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace {

using namespace crossgrain;

constexpr int kRounds = 5;
constexpr int kSweeps = 4;

/// Cells inside a solid as a solve sees them: eighteen neighbours of equal weight each.
FieldGraph<4> box_of_cells(std::uint32_t across) {
  constexpr std::uint32_t kBack = ~std::uint32_t{0};
  constexpr std::array<std::array<std::uint32_t, 3>, 9> kSteps{{{1, 0, 0},
                                                                {0, 1, 0},
                                                                {0, 0, 1},
                                                                {1, 1, 0},
                                                                {1, kBack, 0},
                                                                {1, 0, 1},
                                                                {1, 0, kBack},
                                                                {0, 1, 1},
                                                                {0, 1, kBack}}};
  const std::uint32_t cells = across * across * across;
  const auto row_of = [&](std::size_t cell, std::vector<Adjacency::Neighbour>& row) {
    const auto i = static_cast<std::uint32_t>(cell);
    const std::array<std::uint32_t, 3> at{i % across, i / across % across, i / across / across};
    const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
      // One back from 0 is far outside.
      if (std::max({x, y, z}) < across) row.push_back({(z * across + y) * across + x, 0.2f});
    };
    for (const auto& step : kSteps) {
      add(at[0] + step[0], at[1] + step[1], at[2] + step[2]);
      add(at[0] - step[0], at[1] - step[1], at[2] - step[2]);
    }
  };
  Connectivity connectivity;
  connectivity.adjacency = Adjacency(cells, row_of);
  connectivity.order = greedy_colouring(connectivity.adjacency);
  return {std::make_shared<const Connectivity>(std::move(connectivity)), CellForms<4>(cells)};
}

struct PlainState {
  std::vector<Quaternion> frames;
  std::vector<Coefficients<4>> coefficients;
};

void plain_sweep(const FieldGraph<4>& graph, PlainState& state) {
  for (const std::uint32_t cell : graph.order().cells) {
    Coefficients<4> v{};
    for (const auto& [neighbour, weight] : graph.adjacency()[cell])
      add_scaled(v, weight, state.coefficients[neighbour]);
    const Coefficients<4>& h = state.coefficients[cell];
    const auto lh = apply_generators<4>(h), lv = apply_generators<4>(v);
    const Vector3 gradient{-dot(lh[0], v), -dot(lh[1], v), -dot(lh[2], v)};
    SymmetricMatrix3 hessian;
    int entry = 0;
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b) hessian[entry++] = 0.5 * (dot(lv[a], lh[b]) + dot(lv[b], lh[a]));
    }
    const Vector3 step = guarded_newton_step(hessian, gradient, kLargestStep_rad);
    const Quaternion turned = normalised(from_rotation_vector(step) * state.frames[cell]);
    const Coefficients<4> after = frame_coefficients<4>(turned);
    if (dot(after, v) <= dot(h, v)) continue;
    state.frames[cell] = turned;
    state.coefficients[cell] = after;
  }
}

template <class Sweep>
double million_updates_per_second(std::size_t cells, const Sweep& sweep) {
  const auto begin = std::chrono::steady_clock::now();
  for (int k = 0; k < kSweeps; ++k) sweep();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return 1e-6 * kSweeps * static_cast<double>(cells) / seconds.count();
}

}  // namespace

int main(int argc, char** argv) {
  const int across = argc > 1 ? std::atoi(argv[1]) : 48;
  if (across < 2) {
    std::fprintf(stderr, "sweep_rate [CELLS ACROSS], at least 2\n");
    return 2;
  }
  const ThreadLimit one_thread(1);
  const FieldGraph<4> graph = box_of_cells(static_cast<std::uint32_t>(across));
  FieldState<4> state = state_of<4>(random_frames(graph.size(), 0));
  for (int sweep = 0; sweep < 10; ++sweep) manifold_sweep(graph, state);  // random frames halve many steps
  PlainState plain;
  for (std::size_t i = 0; i < state.size(); ++i) {
    plain.frames.push_back(from_stored(state.frames[i]));
    plain.coefficients.push_back(frame_coefficients<4>(plain.frames[i]));
  }
  double plain_rate = 0, rate = 0;
  for (int round = 0; round < kRounds; ++round) {
    plain_rate =
        std::max(plain_rate, million_updates_per_second(graph.size(), [&] { plain_sweep(graph, plain); }));
    rate =
        std::max(rate, million_updates_per_second(graph.size(), [&] { manifold_sweep(graph, state, 1.0); }));
  }
  std::printf("plain %.2f, library %.2f million updates a second on one thread: %.2f times\n", plain_rate,
              rate, rate / plain_rate);
}
