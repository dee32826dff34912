// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/frame_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "field/field_data.hpp"
#include "sampling/arc_distance.hpp"
#include "sampling/index_arrays.hpp"
#include "sampling/orthonormal_frame.hpp"
#include "sampling/point_order.hpp"
#include "sampling/sampling.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/singularity_graph.hpp"

namespace crossgrain {
namespace {

/// Number of points that are sorted together: more points bring consecutive ones nearer. Takes 80 MB.
constexpr std::size_t kPointsInOrder = std::size_t{1} << 22;

/// Number of points per task and per step of sampling: their samples fit into a core's cache.
constexpr std::size_t kPointsAtOnce = 512;

/// Number of steps ahead by which scattered points are prefetched.
constexpr std::size_t kPrefetched = 16;

template <class T>
void prefetch(const T& object) {
  constexpr std::size_t kCacheLine = 64;
  const auto* const bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t at = 0; at < sizeof(T); at += kCacheLine) __builtin_prefetch(bytes + at);
  __builtin_prefetch(bytes + sizeof(T) - 1);
}

FrameField::Sample sample_of(const Sampler::Result& result, double singular_distance) {
  return {orthonormal_frame(result.frame), result.in_active_cell, result.deviation, singular_distance};
}

/// Throws unless a process has the whole field.
void check_whole(const FieldData& data) {
  if (!data.part.is_whole())
    throw Error(ErrorKind::kUsage, "this is the part of one process; sample and analyse the whole field");
}

void check_points(std::span<const Vector3> points) {
  const auto found = std::find_if_not(points.begin(), points.end(), [](const Vector3& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  });
  if (found != points.end())
    throw Error(ErrorKind::kUsage,
                fmt::format("point {} has a coordinate that is not a finite number", found - points.begin()));
}

}  // namespace

/// Data computed on first use.
struct FrameField::Lazy {
  std::once_flag sampling_once, singularities_once;
  std::optional<Sampler> sampler;
  std::optional<ArcDistance> distance;
  std::shared_ptr<const SingularityGraph> singularities;

  /// Samples the points listed in `order`, at most kPointsAtOnce. The scattered samples are prefetched while
  /// they are computed.
  void sample(std::span<const Vector3> points, std::span<const std::uint32_t> order,
              std::span<Sample> samples) const {
    std::array<Vector3, kPointsAtOnce> row;
    std::array<Sampler::Result, kPointsAtOnce> results;
    std::array<double, kPointsAtOnce> distances;
    const std::size_t count = order.size();
    for (std::size_t k = 0; k < count; ++k) {
      prefetch(points[order[std::min(k + kPrefetched, count - 1)]]);
      row[k] = points[order[k]];
      prefetch(samples[order[k]]);
    }
    sampler->at({row.data(), count}, {results.data(), count});
    distance->at({row.data(), count}, {distances.data(), count});
    for (std::size_t k = 0; k < count; ++k) samples[order[k]] = sample_of(results[k], distances[k]);
  }
};

FrameField::FrameField(std::shared_ptr<const FieldData> data)
    : data_(std::move(data)), lazy_(std::make_shared<Lazy>()) {}

std::size_t FrameField::size() const {
  return data_->tree.size();
}

FrameField::Cell FrameField::cell(std::size_t index) const {
  check_index(index, size(), "cell");
  const auto i = static_cast<CellIndex>(index);
  const Octree& tree = data_->tree;
  return {tree.centre(i), tree.cell_size(i), tree[i].depth(), data_->on_boundary[i] != 0,
          orthonormal_frame(from_stored(data_->frames[i]))};
}

std::vector<Vector3> FrameField::centers() const {
  return for_each_index(size(), [&](std::size_t i) { return data_->tree.centre(static_cast<CellIndex>(i)); });
}

std::vector<double> FrameField::sizes() const {
  return for_each_index(size(),
                        [&](std::size_t i) { return data_->tree.cell_size(static_cast<CellIndex>(i)); });
}

std::vector<int> FrameField::levels() const {
  return for_each_index(size(),
                        [&](std::size_t i) { return data_->tree[static_cast<CellIndex>(i)].depth(); });
}

std::vector<Frame> FrameField::frames() const {
  return for_each_index(size(),
                        [&](std::size_t i) { return orthonormal_frame(from_stored(data_->frames[i])); });
}

std::vector<std::array<float, 4>> FrameField::quaternions() const {
  return for_each_index(size(), [&](std::size_t i) {
    const StoredQuaternion& q = data_->frames[i];
    return std::array{q.w, q.x, q.y, q.z};
  });
}

std::span<const float> FrameField::energy_density() const {
  return data_->energy_density;
}

std::span<const float> FrameField::alignment_deg() const {
  return data_->alignment_deg;
}

std::span<const CellConstraint> FrameField::constraint_classes() const {
  return data_->constraints;
}

std::span<const std::int32_t> FrameField::regions() const {
  return data_->regions;
}

const FrameField::Lazy& FrameField::ready_to_sample() const {
  check_whole(*data_);
  std::call_once(lazy_->sampling_once, [&] {
    lazy_->sampler.emplace(data_->tree, data_->frames, data_->open_faces);
    // With lines beside creases, which do turn frames, and without a surface that may take long to read.
    const SingularityGraph lines =
        singularity_graph(singular_grid_edges(data_->tree, data_->frames, data_->open_faces));
    lazy_->distance.emplace(lines.arcs);
  });
  return *lazy_;
}

FrameField::Sample FrameField::sample(const Vector3& point) const {
  check_points({&point, 1});
  const Lazy& ready = ready_to_sample();
  return sample_of(ready.sampler->at(point), ready.distance->at(point));
}

std::vector<FrameField::Sample> FrameField::sample(std::span<const Vector3> points) const {
  std::vector<Sample> samples(points.size());
  sample(points, samples);
  return samples;
}

void FrameField::sample(std::span<const Vector3> points, std::span<Sample> samples) const {
  if (points.size() != samples.size())
    throw Error(ErrorKind::kUsage, fmt::format("{} points and room for {} samples; the numbers must be equal",
                                               points.size(), samples.size()));
  check_points(points);
  const Lazy& ready = ready_to_sample();
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsInOrder) {
    const std::size_t count = std::min(kPointsInOrder, points.size() - begin);
    const std::vector<std::uint32_t> order = morton_order(data_->tree.root(), points.subspan(begin, count));
    parallel_for_chunks(count, kPointsAtOnce, [&](std::size_t first, std::size_t last) {
      ready.sample(points.subspan(begin, count), std::span(order).subspan(first, last - first),
                   samples.subspan(begin, count));
    });
  }
}

const SingularityGraph& FrameField::singularities() const {
  std::call_once(lazy_->singularities_once, [&] {
    lazy_->singularities = data_->singularities;
    if (lazy_->singularities) return;
    const std::shared_ptr<const SolvedSurface> surface = data_->surface.get();
    std::span<const std::vector<Vector3>> creases;
    if (surface) creases = surface->creases;
    lazy_->singularities = std::make_shared<const SingularityGraph>(
        singularity_graph(singular_grid_edges(data_->tree, data_->frames, data_->open_faces, creases)));
  });
  return *lazy_->singularities;
}

const SolveReport& FrameField::report() const {
  return data_->report;
}

}  // namespace crossgrain
