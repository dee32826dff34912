// SPDX-License-Identifier: Apache-2.0
#include "sampling/places.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"
#include "sampling/nearest_leaf.hpp"

namespace crossgrain {
namespace {

/// Returns for each place 1 if an own leaf holds it.
std::vector<std::uint8_t> are_in_own_leaves(std::span<const Vector3> places, const Octree& tree,
                                            const Share& share) {
  const LeafFinder finder(tree);
  std::vector<std::uint8_t> result(places.size());
  parallel_for(places.size(), [&](std::size_t k) {
    const auto address = tree.root().locate(places[k]);
    const CellIndex leaf = address ? finder.containing(*address) : kNoCell;
    result[k] = leaf != kNoCell && share.owns(leaf);
  });
  return result;
}

/// Returns the indices of entries that are not 0.
std::vector<std::uint64_t> indices_of(std::span<const std::uint8_t> marks) {
  std::vector<std::uint64_t> indices;
  for (std::size_t k = 0; k < marks.size(); ++k)
    if (marks[k] != 0) indices.push_back(k);
  return indices;
}

template <class T>
std::vector<T> selected(std::span<const T> values, std::span<const std::uint64_t> indices) {
  std::vector<T> result;
  for (const std::uint64_t k : indices) result.push_back(values[k]);
  return result;
}

/// A leaf of this or another process beside a place that no leaf holds.
struct Nearby {
  double squared_distance = std::numeric_limits<double>::infinity();
  std::uint64_t number = std::numeric_limits<std::uint64_t>::max();  ///< of the leaf, in the whole level
  Quaternion frame;

  bool is_before(const Nearby& other) const {
    return std::pair(squared_distance, number) < std::pair(other.squared_distance, other.number);
  }
};

}  // namespace

std::vector<std::uint8_t> are_inside(std::span<const Vector3> places, const Octree& tree,
                                     const Share& share) {
  std::vector<std::uint8_t> inside = are_in_own_leaves(places, tree, share);
  for (const std::uint64_t k : of_all(share, indices_of(inside))) inside[k] = 1;
  return inside;
}

std::vector<Quaternion> PlaceSampler::frames_here(std::span<const Vector3> places) const {
  std::vector<Quaternion> frames(places.size());
  parallel_for_chunks(places.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<Sampler::Result> results(end - begin);
    sampler_.at(places.subspan(begin, end - begin), results);
    for (std::size_t k = begin; k < end; ++k) frames[k] = results[k - begin].frame;
  });
  return frames;
}

std::vector<Quaternion> PlaceSampler::frames_at(std::span<const Vector3> places) const {
  if (share_.is_whole()) return frames_here(places);
  std::vector<Quaternion> frames(places.size());
  const std::vector<std::uint64_t> own = indices_of(are_in_own_leaves(places, tree_, share_));
  const auto held = of_all(share_, own);
  const auto found = of_all(share_, frames_here(selected(places, own)));
  std::vector<std::uint8_t> is_outside(places.size(), 1);
  for (std::size_t k = 0; k < held.size(); ++k) {
    frames[held[k]] = found[k];
    is_outside[held[k]] = 0;
  }

  const std::vector<std::uint64_t> outside = indices_of(is_outside);
  std::vector<Nearby> nearest(outside.size());
  parallel_for(tree_.size() == 0 ? 0 : outside.size(), [&](std::size_t k) {
    const Vector3& place = places[outside[k]];
    const CellIndex leaf = nearest_leaf(tree_, place);
    nearest[k] = {squared_distance(place, tree_.root().box(tree_[leaf])), ghosts_.number(share_, leaf),
                  sampler_.frame_of(leaf)};
  });
  const auto candidates = of_all(share_, nearest);
  std::fill(nearest.begin(), nearest.end(), Nearby{});
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    Nearby& best = nearest[k % outside.size()];
    if (candidates[k].is_before(best)) best = candidates[k];
  }
  for (std::size_t k = 0; k < outside.size(); ++k) frames[outside[k]] = nearest[k].frame;
  return frames;
}

}  // namespace crossgrain
