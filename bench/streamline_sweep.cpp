// SPDX-License-Identifier: Apache-2.0
// Measures accuracy and cost of streamlines for tolerances and step sizes (docs/notes/streamlines.md).
//
//   streamline_sweep                  circles about an axis, and how near to a singular line a field holds
//   streamline_sweep FOLDER [MODEL]   lines of a solved field
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numbers>
#include <random>

#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "field/made_grid.hpp"
#include "sampling/sampling.hpp"
#include "singularity/matching.hpp"
#include "singularity/singular_edges.hpp"
#include "solve/tuned_tracer.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

FrameField made_field(int depth, const std::function<Quaternion(const Vector3&)>& frame_at) {
  auto data = std::make_shared<FieldData>();
  data->tree = testing::uniform_octree(depth);
  data->open_faces = testing::all_open(data->tree);
  data->frames = testing::frames_of(data->tree, frame_at);
  data->on_boundary.assign(data->tree.size(), 0);
  return FrameField(data);
}

double distance(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 ab = b - a;
  const double length2 = dot(ab, ab);
  const double t = length2 > 0 ? std::clamp(dot(p - a, ab) / length2, 0.0, 1.0) : 0;
  return norm(p - (a + t * ab));
}

/// Returns the distance from the point of `line` at length `along` from its seed to the nearest point of
/// `reference`; negative if the line is shorter.
double deviation(const Streamline& line, const Streamline& reference, double along) {
  Vector3 place = line.points[line.seed_point];
  double left = along;
  std::size_t i = line.seed_point;
  while (i + 1 < line.points.size() && norm(line.points[i + 1] - line.points[i]) < left) {
    left -= norm(line.points[i + 1] - line.points[i]);
    ++i;
  }
  if (i + 1 == line.points.size()) return -1;
  // Only the points lie on the curve, not the straight pieces between them.
  place = line.points[i];
  double least = INFINITY;
  for (std::size_t k = 0; k + 1 < reference.points.size(); ++k)
    least = std::min(least, distance(place, reference.points[k], reference.points[k + 1]));
  return least;
}

void measure(const FrameField& field, const std::vector<Vector3>& seeds, const std::array<bool, 3>& axes,
             const TriangleMesh* surface, double cell, double along, bool closed_only) {
  StreamlineOptions options;
  options.axes = axes;
  StreamlineTuning tuning;
  tuning.tolerance = 1e-7;
  tuning.smallest_step_cells = 1e-4;
  tuning.largest_step_cells = 0.05;
  const Streamlines reference = TunedTracer(field, options, tuning, surface).trace(seeds);
  std::printf(
      "tolerance  largest  seconds  lines/s   points  mean error  median error  p95 error, cells after %g\n",
      along / cell);
  for (const double largest : {0.5, 1.0, 2.0}) {
    for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5}) {
      tuning = {};
      tuning.tolerance = tolerance;
      tuning.largest_step_cells = largest;
      const TunedTracer tracer(field, options, tuning, surface);
      const auto start = Clock::now();
      const Streamlines result = tracer.trace(seeds);
      const double seconds = seconds_since(start);
      std::size_t points = 0;
      std::vector<double> errors;
      auto other = reference.lines.begin();
      for (const Streamline& line : result.lines) {
        points += line.points.size();
        while (other != reference.lines.end() &&
               (other->seed < line.seed || (other->seed == line.seed && other->axis < line.axis)))
          ++other;
        if (other == reference.lines.end() || other->seed != line.seed || other->axis != line.axis) continue;
        if (closed_only && other->first_end != StreamlineEnd::kClosed) continue;
        const double error = deviation(line, *other, along);
        if (error >= 0) errors.push_back(error / cell);
      }
      std::sort(errors.begin(), errors.end());
      double mean = 0;
      for (const double e : errors) mean += e / static_cast<double>(errors.size());
      std::printf("%9.0e  %7.2f  %7.3f  %7.0f  %7zu  %10.2e  %12.2e  %9.2e  (%zu lines)\n", tolerance,
                  largest, seconds, static_cast<double>(result.lines.size()) / seconds, points, mean,
                  errors.empty() ? 0 : errors[errors.size() / 2],
                  errors.empty() ? 0 : errors[errors.size() * 95 / 100], errors.size());
    }
  }
}

void circles() {
  const int depth = 5;
  const double cell = 1.0 / 32;
  const FrameField field = made_field(depth, [](const Vector3& p) {
    return from_rotation_vector({0, 0, std::atan2(p[1] - 0.5, p[0] - 0.5)});
  });
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> radius(5, 15), angle(0, 2 * std::numbers::pi), height(0.1, 0.9);
  std::vector<Vector3> seeds;
  for (int k = 0; k < 200; ++k) {
    const double r = radius(engine) * cell, a = angle(engine);
    seeds.push_back({0.5 + r * std::cos(a), 0.5 + r * std::sin(a), height(engine)});
  }
  std::printf("circles of radius 5 to 15 cells\n");
  measure(field, seeds, {true, true, false}, nullptr, cell, 30 * cell, true);
  StreamlineOptions options;
  options.axes = {true, true, true};
  std::vector<double> misses;
  for (const Streamline& line : StreamlineTracer(field, options).trace(seeds).lines) {
    if (line.first_end != StreamlineEnd::kClosed) continue;
    const Vector3 last = line.points[line.points.size() - 2], seed = line.points[0];
    misses.push_back(
        std::abs(std::hypot(last[0] - 0.5, last[1] - 0.5) - std::hypot(seed[0] - 0.5, seed[1] - 0.5)) / cell);
  }
  std::sort(misses.begin(), misses.end());
  std::printf("%zu closed; radius off after a turn by %.2e in the median, %.2e at most, cells\n",
              misses.size(), misses[misses.size() / 2], misses.back());
}

void near_singular_line() {
  std::printf("\nmean and largest misorientation of samples around a quarter line, by distance in cells\n");
  const double cell = 1.0 / 32;
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double from : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 1.0, 1.5, 2.0, 3.0}) {
    double sum = 0, worst = 0;
    int count = 0;
    for (int turn = 0; turn < 8; ++turn) {
      const testing::QuarterLine line{{0.5 + 0.01 * turn, 0.5, 0.5},
                                      normalised(Vector3{uniform(engine), uniform(engine), uniform(engine)})};
      const Octree tree = testing::uniform_octree(5);
      const auto frames = testing::frames_of(tree, line);
      const auto open = testing::all_open(tree);
      const auto edges = singular_edges(tree, frames, open);
      const Sampler sampler(tree, frames, open);
      for (int k = 0; k < 4000; ++k) {
        // Circles around a singular edge, not the line itself.
        const GridEdge& edge = edges[engine() % edges.size()];
        const Vector3 middle = tree.root().position(edge.start);
        const Vector3 p = middle + (3.5 * cell) * Vector3{uniform(engine), uniform(engine), uniform(engine)};
        double nearest = INFINITY;
        for (const GridEdge& other : edges)
          nearest = std::min(
              nearest, distance(p, tree.root().position(other.start), tree.root().position(other.end())));
        nearest /= cell;
        if (nearest < from || nearest > from + 0.125 || !sampler.at(p).in_active_cell) continue;
        const Quaternion r = conjugate(line(p)) * sampler.at(p).frame;
        const Quaternion rest = r * conjugate(to_quaternion(nearest_cube_rotation(r)));
        const double angle =
            360 / std::numbers::pi *
            std::atan2(std::sqrt(rest.x * rest.x + rest.y * rest.y + rest.z * rest.z), std::abs(rest.w));
        sum += angle;
        worst = std::max(worst, angle);
        ++count;
      }
    }
    std::printf("%5.3f to %5.3f: %6.2f %6.2f degrees (%d points)\n", from, from + 0.125, sum / count, worst,
                count);
  }
}

/// Measures the smallest step: its cost, and the number of lines that end elsewhere than with steps down to
/// 1/1024.
void small_steps(const FrameField& field, const std::vector<Vector3>& seeds, const TriangleMesh* surface) {
  StreamlineTuning tuning;
  tuning.smallest_step_cells = 1.0 / 1024;
  const Streamlines reference = TunedTracer(field, {}, tuning, surface).trace(seeds);
  std::printf("\nsmallest step  seconds  points  lines that end for another reason\n");
  for (const int parts : {4, 16, 64, 256}) {
    tuning.smallest_step_cells = 1.0 / parts;
    const TunedTracer tracer(field, {}, tuning, surface);
    const auto start = Clock::now();
    const Streamlines result = tracer.trace(seeds);
    const double seconds = seconds_since(start);
    std::size_t points = 0, others = 0;
    for (std::size_t k = 0; k < result.lines.size(); ++k) {
      const Streamline &line = result.lines[k], &same = reference.lines[k];
      points += line.points.size();
      others += line.first_end != same.first_end || line.last_end != same.last_end;
    }
    std::printf("        1/%-3d  %7.3f  %6zu  %zu of %zu\n", parts, seconds, points, others,
                result.lines.size());
  }
}

/// Counts the lines that close, and the length that this saves.
void closing(const FrameField& field, const std::vector<Vector3>& seeds, const TriangleMesh* surface) {
  std::printf("\nclosing distance  closed lines  ends that are too long\n");
  for (const double cells : {0.0, 0.01, 0.05, 0.2, 0.5}) {
    StreamlineTuning tuning;
    tuning.closing_cells = cells;
    std::size_t closed = 0, longest = 0;
    for (const Streamline& line : TunedTracer(field, {}, tuning, surface).trace(seeds).lines) {
      closed += line.first_end == StreamlineEnd::kClosed;
      longest += line.first_end == StreamlineEnd::kLongest;
      longest += line.last_end == StreamlineEnd::kLongest;
    }
    std::printf("%16.2f  %12zu  %zu\n", cells, closed, longest);
  }
}

void solved(const char* folder, const char* model) {
  const FrameField field = read_field(folder);
  TriangleMesh mesh;
  if (model) mesh = read_surface(model);
  const TriangleMesh* surface = model ? &mesh : nullptr;
  auto start = Clock::now();
  const StreamlineTracer tracer(field, {}, surface);
  std::printf("%zu cells, made ready in %.3f s\n", field.size(), seconds_since(start));
  const auto seeds = tracer.spread_seeds(300);
  double cell = INFINITY;
  for (std::size_t i = 0; i < field.size(); ++i) cell = std::min(cell, field.cell(i).size);
  measure(field, seeds, {true, true, true}, surface, cell, 30 * cell, false);
  small_steps(field, seeds, surface);
  closing(field, tracer.spread_seeds(1000), surface);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  if (argc > 1) {
    crossgrain::solved(argv[1], argc > 2 ? argv[2] : nullptr);
  } else {
    crossgrain::circles();
    crossgrain::near_singular_line();
  }
}
