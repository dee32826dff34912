// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/frame_field.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <mutex>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "field/field_data.hpp"
#include "sampling/arc_distance.hpp"
#include "sampling/orthonormal_frame.hpp"
#include "sampling/point_order.hpp"
#include "sampling/sampling.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/singularity_graph.hpp"

namespace crossgrain {

namespace {

/// Points that are sorted together: the more, the nearer are those that follow each other. Takes 80 MB.
constexpr std::size_t kPointsInOrder = std::size_t{1} << 22;

/// Points that one task takes, and every step of sampling in turn: their samples fit into a core's cache.
constexpr std::size_t kPointsAtOnce = 512;

/// Points in no order are asked for so many steps before they are worked on.
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

}  // namespace

/// What is made when it is first asked for.
struct FrameField::Lazy {
  std::once_flag sampling_once, singularities_once;
  std::optional<Sampler> sampler;
  std::optional<ArcDistance> distance;
  std::shared_ptr<const SingularityGraph> singularities;

  /// Answers for the points that `order` names, kPointsAtOnce at most. Where the answers go to, in no order,
  /// comes in from memory while they are worked out.
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
  assert(index < size());
  const auto i = static_cast<CellIndex>(index);
  const Octree& tree = data_->tree;
  return {tree.centre(i), tree.cell_size(i), tree[i].depth(), data_->on_boundary[i] != 0,
          orthonormal_frame(from_stored(data_->frames[i]))};
}

const FrameField::Lazy& FrameField::ready_to_sample() const {
  std::call_once(lazy_->sampling_once, [&] {
    lazy_->sampler.emplace(data_->tree, data_->frames, data_->open_faces);
    lazy_->distance.emplace(singularities().arcs);
  });
  return *lazy_;
}

FrameField::Sample FrameField::sample(const Vector3& point) const {
  const Lazy& ready = ready_to_sample();
  return sample_of(ready.sampler->at(point), ready.distance->at(point));
}

std::vector<FrameField::Sample> FrameField::sample(std::span<const Vector3> points) const {
  std::vector<Sample> samples(points.size());
  sample(points, samples);
  return samples;
}

void FrameField::sample(std::span<const Vector3> points, std::span<Sample> samples) const {
  assert(points.size() == samples.size());
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
    if (!lazy_->singularities)
      lazy_->singularities = std::make_shared<const SingularityGraph>(singularities(SingularityOptions{}));
  });
  return *lazy_->singularities;
}

SingularityGraph FrameField::singularities(const SingularityOptions& options) const {
  return singularity_graph(singular_grid_edges(data_->tree, data_->frames, data_->open_faces), options);
}

const SolveReport& FrameField::report() const {
  return data_->report;
}

}  // namespace crossgrain
