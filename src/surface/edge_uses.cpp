// SPDX-License-Identifier: Apache-2.0
#include "surface/edge_uses.hpp"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Number of triangles of one task, and the most tasks.
constexpr std::size_t kLeastGrain = std::size_t{1} << 15, kMostTasks = 64;

/// Number of buckets by the lower vertex: those of one task are written side by side, and one is sorted in
/// a core's cache.
constexpr std::size_t kBuckets = 1024;

using Triangles = std::span<const std::array<std::uint32_t, 3>>;

std::size_t vertices_of(Triangles triangles, std::size_t grain) {
  std::atomic<std::uint32_t> highest = 0;
  parallel_for_chunks(triangles.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint32_t own = 0;
    for (std::size_t t = begin; t < end; ++t) own = std::max(own, std::ranges::max(triangles[t]));
    std::uint32_t before = highest;
    while (before < own && !highest.compare_exchange_weak(before, own)) {
    }
  });
  return std::size_t{highest} + 1;
}

template <class Visit>
void for_each_use(Triangles triangles, std::size_t begin, std::size_t end, const Visit& visit) {
  for (std::size_t t = begin; t < end; ++t) {
    const auto& triangle = triangles[t];
    if (is_collapsed(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t from = triangle[k], to = triangle[(k + 1) % 3];
      const auto [low, high] = std::minmax(from, to);
      visit(EdgeUse{low << 32 | high, static_cast<std::uint32_t>(t), from < to});
    }
  }
}

}  // namespace

/// Deals the uses to buckets, task by task, and sorts each bucket.
std::vector<EdgeUse> sorted_edge_uses(Triangles triangles) {
  if (triangles.empty()) return {};
  const std::size_t tasks = std::clamp<std::size_t>(triangles.size() / kLeastGrain, 1, kMostTasks);
  const std::size_t grain = (triangles.size() + tasks - 1) / tasks;
  const std::size_t width = (vertices_of(triangles, grain) + kBuckets - 1) / kBuckets;
  const auto bucket_of = [width](const EdgeUse& use) { return use.low() / width; };
  // Where the uses of a task begin in a bucket, at [bucket * tasks + task].
  std::vector<std::size_t> begin(kBuckets * tasks + 1);
  parallel_for_chunks(triangles.size(), grain, [&](std::size_t first, std::size_t last) {
    std::vector<std::size_t> counts(kBuckets);
    for_each_use(triangles, first, last, [&](const EdgeUse& use) { ++counts[bucket_of(use)]; });
    for (std::size_t b = 0; b < kBuckets; ++b) begin[b * tasks + first / grain + 1] = counts[b];
  });
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  auto uses = sized_vector<EdgeUse>(begin.back());
  parallel_for_chunks(triangles.size(), grain, [&](std::size_t first, std::size_t last) {
    std::vector<std::size_t> next(kBuckets);
    for (std::size_t b = 0; b < kBuckets; ++b) next[b] = begin[b * tasks + first / grain];
    for_each_use(triangles, first, last, [&](const EdgeUse& use) { uses[next[bucket_of(use)]++] = use; });
  });
  parallel_for(
      kBuckets,
      [&](std::size_t b) {
        std::sort(uses.begin() + static_cast<std::ptrdiff_t>(begin[b * tasks]),
                  uses.begin() + static_cast<std::ptrdiff_t>(begin[(b + 1) * tasks]),
                  [](const EdgeUse& x, const EdgeUse& y) {
                    return std::tuple(x.edge, x.triangle) < std::tuple(y.edge, y.triangle);
                  });
      },
      1);
  return uses;
}

}  // namespace crossgrain
