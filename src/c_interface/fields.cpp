// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "c_interface/field_calls.hpp"
#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/thread_limit.hpp"
#include "field/field_data.hpp"
#include "results/one_solve.hpp"

namespace crossgrain {
namespace {

/// Number of points that are sampled between two looks at the monitor: a fraction of a second on one thread,
/// and enough to be sorted well.
constexpr std::size_t kPointsAtOnce = std::size_t{1} << 19;

/// Where the samples of the points of one call go; arrays may be empty.
struct SampleArrays {
  std::span<double> frames;
  std::span<std::uint8_t> in_active_cell;
  std::span<double> deviation, singular_distance;

  void put(std::size_t begin, std::span<const FrameField::Sample> samples) const {
    parallel_for(samples.size(), [&](std::size_t i) {
      const FrameField::Sample& sample = samples[i];
      const std::size_t at = begin + i;
      if (!frames.empty())
        for (std::size_t k = 0; k < 9; ++k) frames[9 * at + k] = sample.frame.axes[k / 3][k % 3];
      if (!in_active_cell.empty()) in_active_cell[at] = sample.in_active_cell ? 1 : 0;
      if (!deviation.empty()) deviation[at] = sample.deviation;
      if (!singular_distance.empty()) singular_distance[at] = sample.singular_distance;
    });
  }
};

template <class T>
std::span<T> optional_elements(T* array, std::size_t count, std::size_t each, const char* name) {
  return array == nullptr ? std::span<T>() : elements(array, count, each, name);
}

std::vector<Vector3> points_of(std::span<const double> numbers) {
  std::vector<Vector3> points(numbers.size() / 3);
  parallel_for(points.size(), [&](std::size_t i) {
    points[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  });
  return points;
}

/// Throws Error(kUsage) with the number of the point in the whole list.
void check_finite(std::span<const double> numbers) {
  const auto found =
      std::find_if_not(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
  if (found != numbers.end())
    throw Error(ErrorKind::kUsage, "point " + std::to_string((found - numbers.begin()) / 3) +
                                       " has a coordinate that is not a finite number");
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_status crossgrain_solve(const crossgrain_mesh* mesh, const crossgrain_field* earlier,
                                   const crossgrain_options* options, crossgrain_monitor* monitor,
                                   crossgrain_field** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const TriangleMesh& surface = given(mesh, "mesh").mesh;
    const SolveOptions& its_options = options_or_defaults<SolveOptions>(options);
    FrameField field = earlier == nullptr
                           ? solve(surface, its_options, monitor_of(monitor))
                           : solve_from(earlier->field, surface, its_options, monitor_of(monitor));
    return new crossgrain_field{std::move(field)};
  });
}

crossgrain_status crossgrain_field_read(const char* folder, size_t max_memory_bytes,
                                        crossgrain_monitor* monitor, crossgrain_field** out,
                                        crossgrain_error** error) {
  return made(out, error, [&] {
    const ReadLimits limits(monitor_of(monitor), max_memory_bytes);
    const std::filesystem::path path = &given(folder, "folder");
    return new crossgrain_field{read_one_solve(path, [&] { return read_field(path); })};
  });
}

void crossgrain_field_free(crossgrain_field* field) {
  delete field;
}

size_t crossgrain_field_size(const crossgrain_field* field) {
  return field == nullptr ? 0 : field->field.size();
}

int crossgrain_field_degree(const crossgrain_field* field) {
  return field == nullptr ? 0 : static_cast<int>(field->field.data().degree);
}

crossgrain_status crossgrain_field_centers(const crossgrain_field* field, double* centers,
                                           crossgrain_error** error) {
  return guarded(error, [&] {
    const std::vector<Vector3> all = given(field, "field").field.centers();
    const auto numbers = elements(centers, all.size(), 3, "centers");
    std::copy_n(numbers_of(all), numbers.size(), numbers.begin());
  });
}

crossgrain_status crossgrain_field_sizes(const crossgrain_field* field, double* sizes,
                                         crossgrain_error** error) {
  return guarded(error, [&] {
    const std::vector<double> all = given(field, "field").field.sizes();
    std::copy(all.begin(), all.end(), elements(sizes, all.size(), 1, "sizes").begin());
  });
}

crossgrain_status crossgrain_field_levels(const crossgrain_field* field, int32_t* levels,
                                          crossgrain_error** error) {
  return guarded(error, [&] {
    const std::vector<int> all = given(field, "field").field.levels();
    std::copy(all.begin(), all.end(), elements(levels, all.size(), 1, "levels").begin());
  });
}

crossgrain_status crossgrain_field_frames(const crossgrain_field* field, double* frames,
                                          crossgrain_error** error) {
  return guarded(error, [&] { put_frames(given(field, "field").field.frames(), frames); });
}

const float* crossgrain_field_quaternions(const crossgrain_field* field) {
  if (field == nullptr) return nullptr;
  const auto& frames = field->field.data().frames;
  static_assert(sizeof(StoredQuaternion) == 4 * sizeof(float) && offsetof(StoredQuaternion, w) == 0 &&
                offsetof(StoredQuaternion, z) == 3 * sizeof(float));
  return frames.empty() ? nullptr : &frames.front().w;
}

const uint8_t* crossgrain_field_on_boundary(const crossgrain_field* field) {
  return field == nullptr ? nullptr : data_or_null(field->field.data().on_boundary);
}

const float* crossgrain_field_energy_density(const crossgrain_field* field) {
  return field == nullptr ? nullptr : data_or_null(field->field.data().energy_density);
}

const float* crossgrain_field_alignment_deg(const crossgrain_field* field) {
  return field == nullptr ? nullptr : data_or_null(field->field.data().alignment_deg);
}

const uint8_t* crossgrain_field_constraint_classes(const crossgrain_field* field) {
  if (field == nullptr) return nullptr;
  static_assert(sizeof(CellConstraint) == 1);
  return reinterpret_cast<const uint8_t*>(data_or_null(field->field.data().constraints));
}

const int32_t* crossgrain_field_regions(const crossgrain_field* field) {
  return field == nullptr ? nullptr : data_or_null(field->field.data().regions);
}

crossgrain_status crossgrain_coefficients_of_frames(const double* frames, size_t count, int degree,
                                                    double* coefficients, crossgrain_error** error) {
  return guarded(error, [&] {
    const Degree its_degree = degree_of(degree);
    const auto numbers = elements(frames, count, 9, "frames");
    std::vector<Frame> all(count);
    for (std::size_t i = 0; i < numbers.size(); ++i) all[i / 9].axes[i % 9 / 3][i % 3] = numbers[i];
    const std::vector<double> result = coefficients_of(all, its_degree);
    const std::size_t each = degree == 3 ? 7 : 9;
    std::copy(result.begin(), result.end(), elements(coefficients, count, each, "coefficients").begin());
  });
}

crossgrain_status crossgrain_field_sample(const crossgrain_field* field, const double* points, size_t count,
                                          int threads, double* frames, uint8_t* in_active_cell,
                                          double* deviation, double* singular_distance,
                                          crossgrain_monitor* monitor, crossgrain_error** error) {
  return guarded(error, [&] {
    const auto numbers = elements(points, count, 3, "points");
    const SampleArrays arrays{optional_elements(frames, count, 9, "frames"),
                              optional_elements(in_active_cell, count, 1, "in_active_cell"),
                              optional_elements(deviation, count, 1, "deviation"),
                              optional_elements(singular_distance, count, 1, "singular_distance")};
    check_finite(numbers);
    const ThreadLimit limit(checked_threads(threads));
    std::vector<FrameField::Sample> samples(std::min(kPointsAtOnce, count));
    for (std::size_t begin = 0; begin < count; begin += kPointsAtOnce) {
      monitor_of(monitor).check();
      const std::size_t its_count = std::min(kPointsAtOnce, count - begin);
      const auto its_samples = std::span(samples).first(its_count);
      given(field, "field").field.sample(points_of(numbers.subspan(3 * begin, 3 * its_count)), its_samples);
      arrays.put(begin, its_samples);
    }
  });
}

CROSSGRAIN_FIELD_CALLS(crossgrain_field)
