// SPDX-License-Identifier: Apache-2.0
// Finds equal keys. Keys are distributed by their hash to small tables; one thread fills each table in the
// order of the keys. This is fast, and the result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {

/// Mixes a few words into 64 bits (the finaliser of MurmurHash3 after each word).
template <class Word, std::size_t N>
std::uint64_t hash_of(const std::array<Word, N>& words) {
  std::uint64_t hash = 0;
  for (const Word word : words) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdu;
    hash ^= hash >> 33;
  }
  hash *= 0xc4ceb9fe1a85ec53u;
  return hash ^ hash >> 33;
}

/// Writes to first[i] the smallest j with key_at(j) == key_at(i). Keys are arrays of unsigned numbers, at
/// most 2^32 - 1 of them; key_at is called several times per key, from any thread. Uses a few more bytes per
/// key.
template <class KeyAt>
class FirstEqual {
 public:
  FirstEqual(const KeyAt& key_at, std::span<std::uint32_t> first) : key_at_(key_at), first_(first) {
    // More rounds need less memory at a time, but each round reads all keys.
    constexpr std::size_t kKeysInARound = std::size_t{1} << 20, kMostRounds = 16;
    const std::size_t rounds =
        std::bit_ceil(std::clamp<std::size_t>(count() / kKeysInARound, 1, kMostRounds));
    const std::size_t chunks = std::clamp<std::size_t>(count() / kKeysInAChunk, 1, kMostChunks);
    grain_ = (count() + chunks - 1) / chunks;
    begin_.resize(kTables * chunks + 1);
    for (std::size_t round = 0; round < rounds; ++round) {
      deal(rounds, round);
      fill_tables();
    }
  }

 private:
  using Key = std::decay_t<decltype(std::declval<KeyAt>()(std::size_t{}))>;
  struct Entry {
    Key key;
    std::uint32_t index;
  };

  static constexpr std::size_t kTables = 256, kKeysInAChunk = std::size_t{1} << 15, kMostChunks = 256;
  static constexpr std::uint32_t kNone = UINT32_MAX;

  std::size_t count() const { return first_.size(); }
  std::size_t chunks() const { return (begin_.size() - 1) / kTables; }

  /// Calls visit(table, entry) for the keys of a chunk that belong to this round.
  template <class Visit>
  void visit_keys(std::size_t begin, std::size_t end, std::size_t rounds, std::size_t round,
                  const Visit& visit) const {
    for (std::size_t i = begin; i < end; ++i) {
      const Entry entry{key_at_(i), static_cast<std::uint32_t>(i)};
      const std::uint64_t hash = hash_of(entry.key);
      // The tables use the low bits.
      if ((hash >> 48 & (rounds - 1)) == round) visit(static_cast<std::size_t>(hash >> 56), entry);
    }
  }

  /// Copies the keys of a round to entries_, grouped by table and in order.
  void deal(std::size_t rounds, std::size_t round) {
    std::fill(begin_.begin(), begin_.end(), 0);
    parallel_for_chunks(count(), grain_, [&](std::size_t begin, std::size_t end) {
      std::array<std::size_t, kTables> counts{};
      visit_keys(begin, end, rounds, round, [&](std::size_t table, const Entry&) { ++counts[table]; });
      for (std::size_t table = 0; table < kTables; ++table)
        begin_[table * chunks() + begin / grain_ + 1] = counts[table];
    });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    if (begin_.back() > capacity_) {
      entries_.reset();
      entries_ = std::make_unique_for_overwrite<Entry[]>(begin_.back());
      capacity_ = begin_.back();
    }
    parallel_for_chunks(count(), grain_, [&](std::size_t begin, std::size_t end) {
      std::array<std::size_t, kTables> next;
      for (std::size_t table = 0; table < kTables; ++table)
        next[table] = begin_[table * chunks() + begin / grain_];
      visit_keys(begin, end, rounds, round,
                 [&](std::size_t table, const Entry& entry) { entries_[next[table]++] = entry; });
    });
  }

  void fill_tables() {
    parallel_for_chunks(kTables, kTables / 16, [&](std::size_t table, std::size_t end) {
      std::vector<std::uint32_t> slots;
      for (; table < end; ++table)
        fill_table(
            {entries_.get() + begin_[table * chunks()], entries_.get() + begin_[(table + 1) * chunks()]},
            slots);
    });
  }

  /// Open addressing; `slots` are indices into entries.
  void fill_table(std::span<const Entry> entries, std::vector<std::uint32_t>& slots) const {
    slots.assign(std::bit_ceil(2 * entries.size() + 1), kNone);
    const std::size_t mask = slots.size() - 1;
    for (std::uint32_t i = 0; i < entries.size(); ++i) {
      std::size_t slot = hash_of(entries[i].key) & mask;
      while (slots[slot] != kNone && entries[slots[slot]].key != entries[i].key) slot = (slot + 1) & mask;
      if (slots[slot] == kNone) slots[slot] = i;
      first_[entries[i].index] = entries[slots[slot]].index;
    }
  }

  const KeyAt& key_at_;
  std::span<std::uint32_t> first_;
  std::size_t grain_;
  std::vector<std::size_t> begin_;  ///< begin of a chunk's entries in a table, at [table * chunks + chunk]
  std::unique_ptr<Entry[]> entries_;
  std::size_t capacity_ = 0;
};

template <class KeyAt>
void find_first_equal(const KeyAt& key_at, std::span<std::uint32_t> first) {
  if (!first.empty()) FirstEqual<KeyAt>(key_at, first);
}

/// A set of numbers below a bound that returns the rank of a number.
class RankedSet {
 public:
  /// contains(i) is called for all i below `bound`.
  template <class Contains>
  RankedSet(std::size_t bound, const Contains& contains)
      : words_((bound + kBits - 1) / kBits), before_(words_.size() + 1) {
    parallel_for(
        words_.size(),
        [&](std::size_t w) {
          for (std::size_t i = w * kBits; i < std::min(bound, (w + 1) * kBits); ++i)
            words_[w] |= std::uint64_t{contains(i)} << i % kBits;
        },
        kParallelGrain);
    for (std::size_t w = 0; w < words_.size(); ++w)
      before_[w + 1] = before_[w] + static_cast<std::uint32_t>(std::popcount(words_[w]));
  }

  std::size_t size() const { return before_.back(); }
  bool contains(std::size_t i) const { return words_[i / kBits] >> i % kBits & 1; }

  /// Returns how many numbers of the set are below i.
  std::uint32_t rank(std::size_t i) const {
    const std::uint64_t below = words_[i / kBits] & ((std::uint64_t{1} << i % kBits) - 1);
    return before_[i / kBits] + static_cast<std::uint32_t>(std::popcount(below));
  }

 private:
  static constexpr std::size_t kBits = 64;

  std::vector<std::uint64_t> words_;
  std::vector<std::uint32_t> before_;
};

}  // namespace crossgrain
