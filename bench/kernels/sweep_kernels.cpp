// SPDX-License-Identifier: Apache-2.0
// Kernels of sweeps and projection; items are cells.
#include <benchmark/benchmark.h>

#include "field/manifold_sweep.hpp"
#include "field/relaxation.hpp"
#include "field/solve_tuning.hpp"
#include "guard/plain_box.hpp"
#include "kernels/levels.hpp"

namespace crossgrain::bench {
namespace {

/// Number of sweeps after which the field is reset, so that it never comes near a minimum.
constexpr int kSweepsPerStart = 8;

template <int D, class Sweep>
void sweep(benchmark::State& state, const SweptField<D>& field, const ItemCost& cost,
           const Sweep& one_sweep) {
  FieldState<D> swept = field.start;
  int sweeps = 0;
  for (auto _ : state) {
    one_sweep(swept);
    if (++sweeps % kSweepsPerStart != 0) continue;
    state.PauseTiming();
    swept = field.start;
    state.ResumeTiming();
  }
  report(state, field.graph.size(), cost);
}

template <int D>
void manifold(benchmark::State& state, const SweptField<D>& field) {
  const ItemCost cost =
      sweep_cost<D>(field.graph, manifold_update_flops<D>, SweptData::kFramesAndCoefficients);
  sweep(state, field, cost,
        [&](FieldState<D>& swept) { manifold_sweep(field.graph, swept, SolverTuning{}.over_relaxation); });
}

template <int D>
void relaxation(benchmark::State& state, const SweptField<D>& field) {
  const SolverTuning options;
  const ItemCost cost = sweep_cost<D>(field.graph, relaxation_update_flops<D>, SweptData::kCoefficients);
  sweep(state, field, cost, [&](FieldState<D>& swept) {
    relaxation_sweep(field.graph, swept, options.symmetrisation, options.over_relaxation);
  });
}

template <int D>
void manifold_box(benchmark::State& state) {
  manifold(state, box_field<D>());
}
template <int D, Part kPart>
void manifold_part(benchmark::State& state) {
  manifold(state, part_field<D>(kPart));
}
template <int D>
void relaxation_box(benchmark::State& state) {
  relaxation(state, box_field<D>());
}
template <int D, Part kPart>
void relaxation_part(benchmark::State& state) {
  relaxation(state, part_field<D>(kPart));
}

/// The reference for other sweeps, with its own arrays of doubles: neighbours, frames, coefficients.
void plain(benchmark::State& state) {
  PlainBox box(96);
  for (auto _ : state) box.sweep();
  constexpr CellKind kInside{18, true, false, false};
  const double bytes = 19 * sizeof(std::uint32_t) + 2 * sizeof(Quaternion) + 2 * sizeof(Coefficients<4>);
  report(state, box.size(), {manifold_update_flops<4>(kInside), bytes});
}

/// Projects coefficients after a relaxation to the nearest frames.
template <int D, Part kPart>
void projection(benchmark::State& state) {
  const SolverTuning options;
  const SweptField<D>& field = part_field<D>(kPart);
  FieldState<D> relaxed = field.start;
  for (int k = 0; k < 3; ++k)
    relaxation_sweep(field.graph, relaxed, options.symmetrisation, options.over_relaxation);
  FieldState<D> projected;
  for (auto _ : state) {
    state.PauseTiming();
    projected = relaxed;
    state.ResumeTiming();
    project_to_frames(projected);
  }
  report(state, field.graph.size(),
         {refined_frame_flops<D>(), 2.0 * (sizeof(StoredCoefficients<D>) + sizeof(StoredQuaternion))});
}

void setting(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond);
}

BENCHMARK(plain)->Name("plain sweep in doubles, degree 4, inside")->Apply(setting);
BENCHMARK(manifold_box<4>)->Name("manifold sweep, degree 4, inside")->Apply(setting);
BENCHMARK(manifold_box<3>)->Name("manifold sweep, degree 3, inside")->Apply(setting);
BENCHMARK(manifold_part<4, Part::kBracket>)->Name("manifold sweep, degree 4, bracket")->Apply(setting);
BENCHMARK(manifold_part<4, Part::kTorus>)->Name("manifold sweep, degree 4, torus")->Apply(setting);
BENCHMARK(manifold_part<3, Part::kBracket>)->Name("manifold sweep, degree 3, bracket")->Apply(setting);
BENCHMARK(relaxation_box<4>)->Name("relaxation sweep, degree 4, inside")->Apply(setting);
BENCHMARK(relaxation_part<4, Part::kBracket>)->Name("relaxation sweep, degree 4, bracket")->Apply(setting);
BENCHMARK(relaxation_part<3, Part::kBracket>)->Name("relaxation sweep, degree 3, bracket")->Apply(setting);
BENCHMARK(projection<4, Part::kBracket>)->Name("projection to frames, degree 4")->Apply(setting);
BENCHMARK(projection<3, Part::kBracket>)->Name("projection to frames, degree 3")->Apply(setting);

}  // namespace
}  // namespace crossgrain::bench
