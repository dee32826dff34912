// SPDX-License-Identifier: Apache-2.0
#include "distributed/ghost_search.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// Leaves with an ancestor so many levels up that has only own leaves around it need no look at their
/// surroundings.
constexpr std::array kAncestorLevels{4, 2, 1};

constexpr std::uint64_t code_of(CellAddress cell) {
  return cell.packed() >> 5;
}
std::uint64_t last_code_of(CellAddress cell) {
  return code_of(cell) + (std::uint64_t{1} << 3 * (kMaxDepth - cell.depth())) - 1;
}

/// Calls visit(cell) for the up to 26 cells of the same size around a cell, and for itself.
template <class Visit>
void for_each_around(CellAddress cell, const Visit& visit) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z)
        if (const auto beside = moved(cell, {x, y, z})) visit(*beside);
    }
  }
}

bool touch(CellAddress a, CellAddress b) {
  const GridPoint low_a = a.corner(), low_b = b.corner();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::max(low_a[axis], low_b[axis]) > std::min(low_a[axis] + a.width(), low_b[axis] + b.width()))
      return false;
  }
  return true;
}

void insert(std::vector<int>& ranks, int rank) {
  const auto at = std::lower_bound(ranks.begin(), ranks.end(), rank);
  if (at == ranks.end() || *at != rank) ranks.insert(at, rank);
}

bool touches_any(CellAddress cell, const Octree& tree, const LeafFinder& finder) {
  bool found = false;
  for_each_around(cell, [&](CellAddress beside) {
    const auto [first, last] = finder.over(beside);
    for (CellIndex leaf = first; leaf < last && !found; ++leaf) found = touch(tree[leaf], cell);
  });
  return found;
}

/// Returns for each leaf those in whose shares lie cells of its size around it: the holders of the first
/// layer, and others whose leaves do not touch it.
GhostHolders possible_holders(const Octree& own, const ShareBounds& bounds, int rank) {
  GhostHolders holders(own.size());
  const auto insert_around = [&](CellAddress cell, std::vector<int>& ranks) {
    for_each_around(cell, [&](CellAddress beside) {
      for (const int owner : bounds.owners(beside))
        if (owner != rank) insert(ranks, owner);
    });
  };
  parallel_for_chunks(own.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    // For each number of levels up the last ancestor, and whether it has own leaves around it only.
    std::array<std::pair<CellAddress, bool>, kAncestorLevels.size()> last{};
    for (std::size_t i = begin; i < end; ++i) {
      const CellAddress leaf = own[static_cast<CellIndex>(i)];
      bool is_inner = false;
      for (std::size_t k = 0; k < kAncestorLevels.size() && !is_inner; ++k) {
        const CellAddress ancestor = leaf.ancestor_at(std::max(0, leaf.depth() - kAncestorLevels[k]));
        if (ancestor != last[k].first) {
          std::vector<int> ranks;
          insert_around(ancestor, ranks);
          last[k] = {ancestor, ranks.empty()};
        }
        is_inner = last[k].second;
      }
      if (!is_inner) insert_around(leaf, holders[i]);
    }
  });
  return holders;
}

GhostHolders first_layer(const Octree& own, const LeafFinder& finder, const ShareBounds& bounds,
                         Exchange& exchange) {
  GhostHolders holders = possible_holders(own, bounds, exchange.rank());
  const auto ranks = static_cast<std::size_t>(exchange.ranks());
  std::vector<Bytes> to(ranks);
  for (std::size_t i = 0; i < holders.size(); ++i) {
    for (const int rank : holders[i])
      append_to(to[static_cast<std::size_t>(rank)], std::span(&own.leaves()[i], 1));
  }
  std::vector<Bytes> answers(ranks);
  const std::vector<Bytes> from = exchange.delivered(std::move(to));
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    for (MessageReader reader(from[rank]); !reader.empty();)
      answers[rank].push_back(
          static_cast<std::byte>(touches_any(reader.take<CellAddress>(), own, finder) ? 1 : 0));
  }
  answers = exchange.delivered(std::move(answers));
  std::vector<std::size_t> next(ranks);
  for (std::vector<int>& ranks_of_leaf : holders)
    std::erase_if(ranks_of_leaf, [&](int rank) {
      const auto r = static_cast<std::size_t>(rank);
      return answers[r][next[r]++] == std::byte{0};
    });
  return holders;
}

/// A leaf of another process, with its owner and the other processes that have it in the first layer.
struct FirstGhost {
  CellAddress address;
  std::vector<int> ranks;
};

std::vector<FirstGhost> first_ghosts(const Octree& own, const GhostHolders& holders, Exchange& exchange) {
  std::vector<Bytes> to(static_cast<std::size_t>(exchange.ranks()));
  for (std::size_t i = 0; i < holders.size(); ++i) {
    for (const int rank : holders[i]) {
      Bytes& message = to[static_cast<std::size_t>(rank)];
      const CellAddress address = own[static_cast<CellIndex>(i)];
      const std::uint64_t count = holders[i].size();
      append_to(message, std::span(&address, 1));
      append_to(message, std::span(&count, 1));
      append_to(message, std::span<const int>(holders[i]));
    }
  }
  std::vector<FirstGhost> ghosts;
  const std::vector<Bytes> from = exchange.delivered(std::move(to));
  for (int rank = 0; rank < exchange.ranks(); ++rank) {
    for (MessageReader reader(from[static_cast<std::size_t>(rank)]); !reader.empty();) {
      FirstGhost ghost{reader.take<CellAddress>(), {}};
      ghost.ranks = reader.take<int>(reader.take<std::uint64_t>());
      insert(ghost.ranks, rank);
      ghosts.push_back(std::move(ghost));
    }
  }
  return ghosts;
}

}  // namespace

ShareBounds::ShareBounds(Exchange& exchange, const CellAddress* first) {
  constexpr std::uint64_t kNone = ~std::uint64_t{0};
  const auto begins = gathered_value<std::uint64_t>(exchange, first == nullptr ? kNone : code_of(*first));
  for (std::size_t rank = 0; rank < begins.size(); ++rank) {
    if (begins[rank] == kNone) continue;
    begins_.push_back(begins[rank]);
    ranks_.push_back(static_cast<int>(rank));
  }
}

std::size_t ShareBounds::index(std::uint64_t code) const {
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), code) - begins_.begin();
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, after - 1));
}

int ShareBounds::owner(CellAddress smallest) const {
  return ranks_.empty() ? 0 : ranks_[index(code_of(smallest))];
}

std::span<const int> ShareBounds::owners(CellAddress cell) const {
  if (ranks_.empty()) return {};
  const std::size_t first = index(code_of(cell)), last = index(last_code_of(cell));
  return std::span(ranks_).subspan(first, last - first + 1);
}

GhostHolders ghost_holders(const Octree& own, const ShareBounds& bounds, Exchange& exchange) {
  const int rank = exchange.rank();
  const LeafFinder finder(own);
  const GhostHolders holders = first_layer(own, finder, bounds, exchange);
  const std::vector<FirstGhost> ghosts = first_ghosts(own, holders, exchange);
  GhostHolders both = holders;
  if (own.size() == 0) return both;
  // A leaf of the second layer touches one that is of that process, or that it has as a ghost.
  const auto hand_on = [&](CellAddress middle, const std::vector<int>& ranks) {
    for_each_around(middle, [&](CellAddress beside) {
      const auto [first, last] = finder.over(beside);
      for (CellIndex leaf = first; leaf < last; ++leaf) {
        if (!touch(own[leaf], middle)) continue;
        for (const int other : ranks)
          if (other != rank) insert(both[leaf], other);
      }
    });
  };
  for (CellIndex leaf = 0; leaf < own.size(); ++leaf)
    if (!holders[leaf].empty()) hand_on(own[leaf], holders[leaf]);
  for (const FirstGhost& ghost : ghosts) hand_on(ghost.address, ghost.ranks);
  return both;
}

}  // namespace crossgrain
