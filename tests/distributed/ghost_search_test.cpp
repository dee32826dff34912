// SPDX-License-Identifier: Apache-2.0
#include "distributed/ghost_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <set>

#include "distributed/thread_exchange.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;
using testing::run_ranks;

/// Leaves of several sizes, a part of them missing.
std::vector<CellAddress> random_leaves(RandomSamples& random) {
  std::vector<CellAddress> leaves;
  const std::function<void(CellAddress)> add = [&](CellAddress cell) {
    if (cell.depth() >= 2 && random.uniform(0, 1) < 0.15) return;
    if (cell.depth() == 6 || (cell.depth() >= 2 && random.uniform(0, 1) < 0.5)) {
      leaves.push_back(cell);
      return;
    }
    for (int octant = 0; octant < 8; ++octant) add(cell.child(octant));
  };
  add(CellAddress::root());
  std::sort(leaves.begin(), leaves.end());
  return leaves;
}

bool touch(CellAddress a, CellAddress b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.corner()[axis] > b.corner()[axis] + b.width() || b.corner()[axis] > a.corner()[axis] + a.width())
      return false;
  }
  return true;
}

/// The leaves outside [begin, end) that touch one of those, and those that touch one of these, by all pairs.
std::set<std::size_t> two_layers(const std::vector<CellAddress>& leaves, std::size_t begin, std::size_t end) {
  std::vector<std::size_t> layer;
  for (std::size_t i = begin; i < end; ++i) layer.push_back(i);
  std::set<std::size_t> found;
  for (int round = 0; round < 2; ++round) {
    std::vector<std::size_t> next;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if ((i >= begin && i < end) || found.contains(i)) continue;
      if (std::any_of(layer.begin(), layer.end(), [&](std::size_t j) { return touch(leaves[i], leaves[j]); }))
        next.push_back(i);
    }
    found.insert(next.begin(), next.end());
    layer = next;
  }
  return found;
}

TEST(GhostHolders, AreThoseWhoseLeavesAreWithinTwoLayers) {
  RandomSamples random(5);
  for (const int ranks : {1, 2, 3, 7}) {
    const std::vector<CellAddress> leaves = random_leaves(random);
    // Shares of any size, some of them empty.
    std::vector<std::size_t> cuts{0, leaves.size()};
    for (int k = 1; k < ranks; ++k)
      cuts.push_back(static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(leaves.size())));
    if (ranks == 7) cuts[3] = cuts[2];
    std::sort(cuts.begin(), cuts.end());
    std::mutex mutex;
    std::vector<std::set<std::size_t>> ghosts(static_cast<std::size_t>(ranks));
    run_ranks(ranks, [&](Exchange& exchange) {
      const auto rank = static_cast<std::size_t>(exchange.rank());
      const std::vector<CellAddress> own(leaves.begin() + static_cast<std::ptrdiff_t>(cuts[rank]),
                                         leaves.begin() + static_cast<std::ptrdiff_t>(cuts[rank + 1]));
      const ShareBounds bounds(exchange, own.empty() ? nullptr : own.data());
      const GhostHolders holders = ghost_holders(Octree({{0, 0, 0}, 1}, own), bounds, exchange);
      const std::lock_guard lock(mutex);
      for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_EQ(bounds.owner(own[i]), exchange.rank());
        for (const int holder : holders[i]) ghosts[static_cast<std::size_t>(holder)].insert(cuts[rank] + i);
      }
    });
    for (std::size_t rank = 0; rank < ghosts.size(); ++rank) {
      const std::set<std::size_t> needed = two_layers(leaves, cuts[rank], cuts[rank + 1]);
      EXPECT_EQ(ghosts[rank], needed) << rank << " of " << ranks;
    }
  }
}

}  // namespace
}  // namespace crossgrain
