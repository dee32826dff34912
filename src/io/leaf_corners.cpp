// SPDX-License-Identifier: Apache-2.0
#include "io/leaf_corners.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kCornersPerLeaf = 8;

/// Leaves whose corners are gathered together: enough that few of them are met in two gatherings.
constexpr std::size_t kGatheredLeaves = 1 << 14;

std::uint64_t key_of(const GridPoint& point) {
  return morton::spread(static_cast<std::uint64_t>(point[0])) |
         morton::spread(static_cast<std::uint64_t>(point[1])) << 1 |
         morton::spread(static_cast<std::uint64_t>(point[2])) << 2;
}

GridPoint point_of(std::uint64_t key) {
  return {static_cast<std::int32_t>(morton::gather(key)), static_cast<std::int32_t>(morton::gather(key >> 1)),
          static_cast<std::int32_t>(morton::gather(key >> 2))};
}

std::uint64_t corner_key(CellAddress leaf, std::size_t corner) {
  GridPoint point = leaf.corner();
  for (int axis = 0; axis < 3; ++axis) {
    if (corner >> axis & 1) point[axis] += leaf.width();
  }
  return key_of(point);
}

void sort_unique(std::vector<std::uint64_t>& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// The place of `key`, which is there, in sorted keys, looked for in growing steps from a place near it.
std::size_t find_near(const std::vector<std::uint64_t>& keys, std::uint64_t key, std::size_t guess) {
  std::size_t low = guess, high = guess, step = 1;
  while (keys[low] > key) {
    high = low;
    low -= std::min(low, step);
    step *= 2;
  }
  while (high < keys.size() && keys[high] < key) {
    low = high;
    high += step;
    step *= 2;
  }
  const auto end = keys.begin() + static_cast<std::ptrdiff_t>(std::min(high + 1, keys.size()));
  const auto found = std::lower_bound(keys.begin() + static_cast<std::ptrdiff_t>(low), end, key);
  assert(found != end && *found == key);
  return static_cast<std::size_t>(found - keys.begin());
}

}  // namespace

LeafCorners::LeafCorners(const Octree& tree) : tree_(tree) {
  std::vector<std::vector<std::uint64_t>> runs((tree.size() + kGatheredLeaves - 1) / kGatheredLeaves);
  parallel_for_chunks(tree.size(), kGatheredLeaves, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint64_t> keys;
    keys.reserve(kCornersPerLeaf * (end - begin));
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < kCornersPerLeaf; ++k) keys.push_back(corner_key(tree.leaves()[i], k));
    }
    sort_unique(keys);
    runs[begin / kGatheredLeaves].assign(keys.begin(), keys.end());
  });
  std::size_t total = 0;
  for (const auto& run : runs) total += run.size();
  keys_.reserve(total);
  for (auto& run : runs) {
    keys_.insert(keys_.end(), run.begin(), run.end());
    run = {};
  }
  sort_unique(keys_);
}

Vector3 LeafCorners::position(std::size_t corner) const {
  return tree_.root().position(point_of(keys_[corner]));
}

void LeafCorners::write_indices(std::size_t begin, std::size_t end, std::int64_t* out) const {
  // Each corner of a leaf is close to the same corner of the leaf before.
  std::array<std::size_t, kCornersPerLeaf> places;
  for (std::size_t entry = begin; entry < end; ++entry) {
    const std::size_t k = entry % kCornersPerLeaf;
    const std::uint64_t key = corner_key(tree_.leaves()[entry / kCornersPerLeaf], k);
    if (entry < begin + kCornersPerLeaf)
      places[k] = static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
    else
      places[k] = find_near(keys_, key, places[k]);
    *out++ = static_cast<std::int64_t>(places[k]);
  }
}

}  // namespace crossgrain
