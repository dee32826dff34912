// SPDX-License-Identifier: Apache-2.0
// Kernels of a solved field: nearest frames to arbitrary coefficients, sampling, writing.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "crossgrain/result_folder.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/thread_limit.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/frame_cover.hpp"
#include "kernels/item_cost.hpp"
#include "kernels/update_flops.hpp"
#include "support/shapes.hpp"

namespace crossgrain::bench {
namespace {

FrameField solved_bracket(int resolution) {
  SolveOptions options;
  options.resolution = resolution;
  options.threads = 1;
  return solve(make_bracket(64), options);
}

const FrameField& solved_field() {
  static const FrameField field = solved_bracket(128);
  return field;
}

/// A field of a million cells.
const FrameField& large_field() {
  static const FrameField field = solved_bracket(431);
  return field;
}

enum class Spread {
  kOverVolume,  ///< random; few in small cells
  kOverCells,   ///< random, the same number in every cell
  kInOrder,     ///< the same in the order of cells
};

/// Random points in cells.
std::vector<Vector3> points_in(const FrameField& field, std::size_t count, Spread spread) {
  std::mt19937_64 random(1);
  std::vector<double> volume_up_to(field.size());
  double volume = 0;
  for (std::size_t i = 0; i < field.size(); ++i) volume_up_to[i] = volume += std::pow(field.cell(i).size, 3);
  const auto index = [&](std::size_t k) -> std::size_t {
    if (spread == Spread::kInOrder) return k * field.size() / count;
    if (spread == Spread::kOverCells) return random() % field.size();
    const double share = 0x1p-64 * static_cast<double>(random());
    const auto at = std::upper_bound(volume_up_to.begin(), volume_up_to.end() - 1, share * volume);
    return static_cast<std::size_t>(at - volume_up_to.begin());
  };
  const auto deviate = [&] { return 0x1p-64 * static_cast<double>(random()) - 0.5; };
  std::vector<Vector3> points;
  for (std::size_t k = 0; k < count; ++k) {
    const FrameField::Cell cell = field.cell(index(k));
    const Vector3& c = cell.center;
    points.push_back(
        {c[0] + cell.size * deviate(), c[1] + cell.size * deviate(), c[2] + cell.size * deviate()});
  }
  return points;
}

/// Bytes of a sample: the frames and rotations of eight cells, the point, the result.
ItemCost sample_cost() {
  constexpr double kCellBytes = 16 + 40 + 8 + 1;  // frame, turn, address, open faces
  return {sample_flops(), 8 * kCellBytes + sizeof(Vector3) + sizeof(FrameField::Sample)};
}

/// The search over all frames with eight refined starts, the fallback of projection.
template <int D>
void nearest_frames(benchmark::State& state) {
  constexpr int kStarts = 8;  // harmonics/nearest_frame.cpp
  std::mt19937_64 random(1);
  std::vector<Coefficients<D>> targets(1000);
  for (Coefficients<D>& target : targets) {
    for (double& value : target) value = 0x1p-63 * static_cast<double>(random()) - 1;
  }
  for (auto _ : state) {
    for (const Coefficients<D>& target : targets) benchmark::DoNotOptimize(nearest_frame<D>(target));
  }
  const double flops = kStarts * refined_frame_flops<D>() + 2.0 * kCoverSize * kCoefficientCount<D>;
  report(state, targets.size(), {flops, sizeof(Coefficients<D>) + sizeof(Quaternion)});
}

/// Samples points one by one in random order.
void sampling(benchmark::State& state) {
  const FrameField& field = solved_field();
  const std::vector<Vector3> points = points_in(field, 20000, Spread::kOverCells);
  benchmark::DoNotOptimize(field.sample(points[0]));  // finds the turns of all cells
  for (auto _ : state) {
    for (const Vector3& point : points) benchmark::DoNotOptimize(field.sample(point));
  }
  report(state, points.size(), sample_cost());
}

/// Samples as many points as there are cells in one call.
void sampling_many(benchmark::State& state, Spread spread) {
  const ThreadLimit limit(1);
  const FrameField& field = large_field();
  const std::vector<Vector3> points = points_in(field, 1000000, spread);
  std::vector<FrameField::Sample> samples = field.sample(points);
  for (auto _ : state) field.sample(points, samples);
  report(state, points.size(), sample_cost());
}

/// Writes field.vtu with all arrays of cells, compressed. Bytes: the arrays before compression, which takes
/// nearly all of the time and no floating-point arithmetic.
void writing(benchmark::State& state) {
  const FrameField& field = solved_field();
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("crossgrain_kernels_" + std::to_string(getpid()));
  for (auto _ : state) write_field(field, folder);
  std::filesystem::remove_all(folder);
  constexpr double kAxes = 36, kCoefficients = 36, kScalars = 14, kIndices = 64 + 8 + 1, kCorner = 24,
                   kKept = 8 + 16 + 1;
  report(state, field.size(), {0, kAxes + kCoefficients + kScalars + kIndices + kCorner + kKept});
}

BENCHMARK(nearest_frames<4>)
    ->Name("nearest frame to any coefficients, degree 4")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_frames<3>)
    ->Name("nearest frame to any coefficients, degree 3")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(sampling)->Name("sampling at a point")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sampling_many, over_volume, Spread::kOverVolume)
    ->Name("sampling at many points, over the solid")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sampling_many, over_cells, Spread::kOverCells)
    ->Name("sampling at many points, over the cells")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sampling_many, in_order, Spread::kInOrder)
    ->Name("sampling at many points, cell by cell")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(writing)->Name("writing a cell to field.vtu")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace crossgrain::bench
