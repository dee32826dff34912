// SPDX-License-Identifier: Apache-2.0
// Notation: the key of a corner is its Morton code, its coordinates' bits interleaved.
#include "results/leaf_corners.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kCornersPerLeaf = 8;

/// Leaves of a group: few enough that the table of their corners stays in a core's cache. In a full cube of
/// that many leaves a sixth of the corners are shared.
constexpr std::size_t kGroupLeaves = 1 << 12;

/// Groups that one task numbers.
constexpr std::size_t kGroupsAtOnce = 8;

/// Groups whose shared corners one task collects.
constexpr std::size_t kGroupsGathered = 64;

constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
constexpr std::uint64_t kNoNumber = ~std::uint64_t{0};

GridPoint point_of(std::uint64_t key) {
  return {static_cast<std::int32_t>(morton::gather(key)), static_cast<std::int32_t>(morton::gather(key >> 1)),
          static_cast<std::int32_t>(morton::gather(key >> 2))};
}

std::uint64_t low_key(CellAddress leaf) {
  return leaf.packed() >> 5;
}

/// Returns whether corner k of a leaf is on the high side of an axis, in the order of VTK_HEXAHEDRON: around
/// the lower square, then around the upper one.
constexpr bool is_high(std::size_t k, int axis) {
  const std::size_t voxel_corner = k ^ (k >> 1 & 1);  // bit a tells the side of axis a
  return voxel_corner >> axis & 1;
}

/// Returns the keys of a leaf's corners. The width is added to one coordinate with the bits of the others
/// set, so that carries propagate across them.
std::array<std::uint64_t, kCornersPerLeaf> corner_keys(CellAddress leaf) {
  constexpr std::uint64_t kBitsOfX = 0x1249249249249249;
  const std::uint64_t low = low_key(leaf), width = std::uint64_t{1} << 3 * (kMaxDepth - leaf.depth());
  std::array<std::uint64_t, kCornersPerLeaf> keys{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::uint64_t bits = kBitsOfX << axis;
    const std::uint64_t high = ((low | ~bits) + (width << axis)) & bits;
    for (std::size_t k = 0; k < kCornersPerLeaf; ++k) keys[k] |= is_high(k, axis) ? high : low & bits;
  }
  return keys;
}

void sort_unique(std::vector<std::uint64_t>& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// Hash table from keys to numbers with open addressing, at most half full.
class NumberTable {
 public:
  NumberTable() : entries_(kLeastEntries) {}

  void clear() {
    std::fill(entries_.begin(), entries_.end(), Entry{});
    used_ = 0;
  }

  /// Returns a reference to the number of `key`. If it is kNoNumber, the key is new, and the caller must set
  /// the number before the next call.
  std::uint64_t& operator[](std::uint64_t key) {
    if (2 * used_ == entries_.size()) grow();
    Entry& entry = place_of(key);
    if (entry.key == kNoKey) {
      entry.key = key;
      ++used_;
    }
    return entry.number;
  }

 private:
  struct Entry {
    std::uint64_t key = kNoKey, number = kNoNumber;
  };

  static constexpr std::size_t kLeastEntries = 4 * kGroupLeaves;

  Entry& place_of(std::uint64_t key) {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15;  // times 2^64: spreads keys that are close
    const std::size_t mask = entries_.size() - 1;
    std::size_t place = key * kGoldenRatio >> (64 - std::bit_width(mask));
    while (entries_[place].key != key && entries_[place].key != kNoKey) place = (place + 1) & mask;
    return entries_[place];
  }

  void grow() {
    std::vector<Entry> before(2 * entries_.size());
    before.swap(entries_);
    for (const Entry& entry : before) {
      if (entry.key != kNoKey) place_of(entry.key) = entry;
    }
  }

  std::vector<Entry> entries_;
  std::size_t used_ = 0;
};

}  // namespace

/// Numbers the corners of a group, leaf by leaf.
class LeafCorners::Numbering {
 public:
  explicit Numbering(const LeafCorners& corners) : corners_(corners) {}

  void begin_group(std::size_t group) {
    table_.clear();
    end_key_ = corners_.first_key(group + 1);
    next_ = corners_.begins_[group];
    for (std::size_t i = corners_.shared_begins_[group]; i < corners_.shared_begins_[group + 1]; ++i)
      table_[corners_.shared_[i]] = next_++;
  }

  /// Numbers the corner and returns true if it belongs to the group itself and is new.
  bool is_new_own(std::uint64_t key) {
    if (key >= end_key_) return false;
    std::uint64_t& number = table_[key];
    if (number != kNoNumber) return false;
    number = next_++;
    return true;
  }

  std::uint64_t number_of(std::uint64_t key) {
    std::uint64_t& number = table_[key];
    if (number == kNoNumber) number = key < end_key_ ? next_++ : number_of_shared(key);
    return number;
  }

  /// The next unused number.
  std::uint64_t next() const { return next_; }

 private:
  std::uint64_t number_of_shared(std::uint64_t key) const {
    const std::vector<std::uint64_t>& shared = corners_.shared_;
    const std::vector<std::size_t>& begins = corners_.shared_begins_;
    const auto place = std::lower_bound(shared.begin(), shared.end(), key) - shared.begin();
    assert(shared[static_cast<std::size_t>(place)] == key);
    const auto after = std::upper_bound(begins.begin(), begins.end(), static_cast<std::size_t>(place));
    const auto group = static_cast<std::size_t>(after - begins.begin()) - 1;
    return corners_.begins_[group] + static_cast<std::size_t>(place) - begins[group];
  }

  const LeafCorners& corners_;
  NumberTable table_;
  std::uint64_t end_key_ = 0;
  std::uint64_t next_ = 0;
};

LeafCorners::LeafCorners(const Octree& tree) : tree_(tree) {
  begins_.resize((tree.size() + kGroupLeaves - 1) / kGroupLeaves + 1, 0);
  find_shared();
  find_own();
}

std::pair<std::size_t, std::size_t> LeafCorners::leaves_of(std::size_t group) const {
  return {group * kGroupLeaves, std::min((group + 1) * kGroupLeaves, tree_.size())};
}

/// Returns the first key of a group; for the group after the last, a key greater than all.
std::uint64_t LeafCorners::first_key(std::size_t group) const {
  return group < groups() ? low_key(tree_.leaves()[group * kGroupLeaves]) : kNoKey;
}

/// Adds the corners of a group's leaves that later groups number; repetitions are possible.
void LeafCorners::add_keys_beyond(std::size_t group, std::vector<std::uint64_t>& keys) const {
  const std::uint64_t end_key = first_key(group + 1);
  const auto [begin, end] = leaves_of(group);
  for (std::size_t i = begin; i < end; ++i) {
    for (const std::uint64_t key : corner_keys(tree_.leaves()[i])) {
      if (key >= end_key) keys.push_back(key);
    }
  }
}

void LeafCorners::find_shared() {
  std::vector<std::vector<std::uint64_t>> beyond((groups() + kGroupsGathered - 1) / kGroupsGathered);
  parallel_for_chunks(groups(), kGroupsGathered, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint64_t> keys;
    for (std::size_t group = begin; group < end; ++group) add_keys_beyond(group, keys);
    sort_unique(keys);
    beyond[begin / kGroupsGathered].assign(keys.begin(), keys.end());
  });

  // Each task collects the corners that its groups number, from all groups before.
  std::vector<std::vector<std::uint64_t>> gathered(beyond.size());
  parallel_for_chunks(groups(), kGroupsGathered, [&](std::size_t begin, std::size_t end) {
    const std::size_t own = begin / kGroupsGathered;
    std::vector<std::uint64_t> keys;
    for (std::size_t run = 0; run <= own; ++run) {
      const auto first = std::lower_bound(beyond[run].begin(), beyond[run].end(), first_key(begin));
      keys.insert(keys.end(), first, std::lower_bound(first, beyond[run].end(), first_key(end)));
    }
    sort_unique(keys);
    gathered[own].assign(keys.begin(), keys.end());
  });
  beyond = {};

  std::size_t count = 0;
  for (const auto& keys : gathered) count += keys.size();
  shared_.reserve(count);
  for (std::vector<std::uint64_t>& keys : gathered) {
    shared_.insert(shared_.end(), keys.begin(), keys.end());
    keys = {};
  }
  shared_begins_.resize(groups() + 1);
  parallel_for(groups() + 1, [&](std::size_t group) {
    const auto first = std::lower_bound(shared_.begin(), shared_.end(), first_key(group));
    shared_begins_[group] = static_cast<std::size_t>(first - shared_.begin());
  });
}

void LeafCorners::find_own() {
  own_.resize(tree_.size());
  std::vector<std::size_t> counts(groups());
  parallel_for_chunks(groups(), kGroupsAtOnce, [&](std::size_t first, std::size_t last) {
    Numbering numbering(*this);
    for (std::size_t group = first; group < last; ++group) {
      numbering.begin_group(group);
      const auto [begin, end] = leaves_of(group);
      for (std::size_t i = begin; i < end; ++i) {
        const auto keys = corner_keys(tree_.leaves()[i]);
        unsigned own = 0;
        for (std::size_t k = 0; k < kCornersPerLeaf; ++k)
          own |= (numbering.is_new_own(keys[k]) ? 1u : 0u) << k;
        own_[i] = static_cast<std::uint8_t>(own);
      }
      counts[group] = numbering.next();
    }
  });
  for (std::size_t group = 0; group < groups(); ++group) begins_[group + 1] = begins_[group] + counts[group];
}

void LeafCorners::write_positions(std::size_t begin, std::size_t end, double* out) const {
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), begin);
  std::size_t group = static_cast<std::size_t>(after - begins_.begin()) - 1, corner = begins_[group];
  const auto write = [&](std::uint64_t key) {
    if (corner >= begin && corner < end)
      out = std::ranges::copy(tree_.root().position(point_of(key)), out).out;
    ++corner;
  };
  for (; corner < end; ++group) {
    for (std::size_t i = shared_begins_[group]; i < shared_begins_[group + 1]; ++i) write(shared_[i]);
    const auto [first, last] = leaves_of(group);
    for (std::size_t i = first; i < last; ++i) {
      if (own_[i] == 0) continue;
      const auto keys = corner_keys(tree_.leaves()[i]);
      for (std::size_t k = 0; k < kCornersPerLeaf; ++k) {
        if (own_[i] >> k & 1) write(keys[k]);
      }
    }
  }
}

template <class Index>
void LeafCorners::write_indices(std::size_t begin, std::size_t end, Index* out) const {
  Numbering numbering(*this);
  std::size_t entry = begin / kCornersPerLeaf / kGroupLeaves * kGroupLeaves * kCornersPerLeaf;
  for (std::size_t group = entry / kCornersPerLeaf / kGroupLeaves; entry < end; ++group) {
    numbering.begin_group(group);
    const auto [first, last] = leaves_of(group);
    for (std::size_t i = first; i < last && entry < end; ++i) {
      for (const std::uint64_t key : corner_keys(tree_.leaves()[i])) {
        const std::uint64_t number = numbering.number_of(key);
        if (entry >= begin && entry < end) *out++ = static_cast<Index>(number);
        ++entry;
      }
    }
  }
}

template void LeafCorners::write_indices(std::size_t, std::size_t, std::int32_t*) const;
template void LeafCorners::write_indices(std::size_t, std::size_t, std::int64_t*) const;

}  // namespace crossgrain
