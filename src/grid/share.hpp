// SPDX-License-Identifier: Apache-2.0
// Which leaves of a level this process owns.
//
//   leaves in this process     | ghosts below |     own     | ghosts above |
//                              0            begin          end           size
//
// The leaves of all processes together, each counted by its owner, are the level. They are numbered in the
// order of their addresses; own leaves have successive numbers. Ghosts are leaves of other processes, in two
// layers around the own ones: all that touch one of those, and all that touch one of these. They have surface
// and winding numbers, and frames and coefficients that their owners send.
//
// All processes that share a level call the functions below together. Of a whole level they return what this
// process has, so code that computes with a share hardly asks whether there are others.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/exchange.hpp"
#include "base/parallel.hpp"

namespace crossgrain {

/// Own leaves are cut at multiples of so many: no block of a sweep and no chunk of a sum belongs to two
/// processes. The frames, coefficients and neighbour lists of a block fit into a core's own cache.
inline constexpr std::size_t kShareUnit = 4096;

struct Share {
  std::uint32_t begin = 0, end = 0;
  std::uint64_t before = 0;      ///< number of the first own leaf; a multiple of kShareUnit
  std::uint64_t of_all = 0;      ///< leaves of the level
  Exchange* exchange = nullptr;  ///< null: this process has the whole level

  bool is_whole() const { return exchange == nullptr; }
  bool is_of_first() const { return is_whole() || exchange->rank() == 0; }
  std::size_t size() const { return end - begin; }
  bool owns(std::size_t leaf) const { return leaf >= begin && leaf < end; }
};

/// The share of a process that has all of so many leaves.
inline Share whole_share(std::size_t leaves) {
  return {0, static_cast<std::uint32_t>(leaves), 0, leaves, nullptr};
}

/// The share in so many leaves of a process that has this part, or all if the part has no exchange.
inline Share share_of(const Share& part, std::size_t leaves) {
  return part.is_whole() ? whole_share(leaves) : part;
}

/// Numbers and owners of the ghosts, those below first.
struct Ghosts {
  std::vector<std::uint64_t> numbers;
  std::vector<int> owners;  ///< ranks

  /// Index of the ghost that is this leaf. Precondition: it is not an own one.
  static std::size_t index(const Share& share, std::size_t leaf) {
    return leaf < share.begin ? leaf : leaf - share.size();
  }
  std::uint64_t number(const Share& share, std::size_t leaf) const {
    return share.owns(leaf) ? share.before + (leaf - share.begin) : numbers[index(share, leaf)];
  }
  /// Inverse of `number`; none if the leaf is not in this process.
  std::optional<std::uint32_t> leaf_of(const Share& share, std::uint64_t number) const {
    if (number >= share.before && number < share.before + share.size())
      return share.begin + static_cast<std::uint32_t>(number - share.before);
    const auto ghost = std::lower_bound(numbers.begin(), numbers.end(), number);
    if (ghost == numbers.end() || *ghost != number) return std::nullopt;
    const auto at = static_cast<std::uint32_t>(ghost - numbers.begin());
    return at < share.begin ? at : at + (share.end - share.begin);
  }
};

template <class T>
std::vector<T> own_values(const Share& share, const std::vector<T>& values) {
  return {values.begin() + share.begin, values.begin() + share.end};
}

/// Returns the values of all ranks, those of rank 0 first.
template <class T>
std::vector<T> of_all(const Share& share, std::vector<T> mine) {
  return share.is_whole() ? std::move(mine) : gathered_values<T>(*share.exchange, mine);
}

/// Returns the value of each rank.
template <class T>
std::vector<T> of_each(const Share& share, const T& mine) {
  return of_all(share, std::vector<T>{mine});
}

/// Returns the largest of the values that the ranks pass.
template <class T>
T largest_of_all(const Share& share, const T& mine) {
  const std::vector<T> all = of_each(share, mine);
  return *std::max_element(all.begin(), all.end());
}

/// Returns the smallest of the values that the ranks pass.
template <class T>
T smallest_of_all(const Share& share, const T& mine) {
  const std::vector<T> all = of_each(share, mine);
  return *std::min_element(all.begin(), all.end());
}

inline bool is_so_in_any(const Share& share, bool mine) {
  return largest_of_all<char>(share, mine ? 1 : 0) != 0;
}

inline bool is_so_in_all(const Share& share, bool mine) {
  return !is_so_in_any(share, !mine);
}

/// Returns the sum of the numbers that the ranks before this one pass.
inline std::uint64_t sum_before(const Share& share, std::uint64_t mine) {
  const std::vector<std::uint64_t> all = of_each(share, mine);
  return std::accumulate(all.begin(), all.begin() + (share.is_whole() ? 0 : share.exchange->rank()),
                         std::uint64_t{0});
}

/// Adds up the numbers that the ranks pass, those with one index each.
template <std::unsigned_integral T>
void add_up(const Share& share, std::span<T> numbers) {
  const std::vector<T> all = of_all(share, std::vector<T>(numbers.begin(), numbers.end()));
  std::fill(numbers.begin(), numbers.end(), T{0});
  for (std::size_t k = 0; k < all.size(); ++k) numbers[k % numbers.size()] += all[k];
}

/// Returns the values of all ranks, those of rank 0 first; only there.
template <class T>
std::vector<T> on_first(const Share& share, std::vector<T> values) {
  return share.is_whole() ? std::move(values) : moved_to_first(*share.exchange, std::move(values));
}

/// Adds the terms of all ranks in order, those of this one being terms[0], terms[1], ...
inline double sum_of_all(const Share& share, std::span<const double> terms) {
  return share.is_whole() ? std::accumulate(terms.begin(), terms.end(), 0.0)
                          : running_sum(*share.exchange, terms);
}

/// Returns the sum of term(leaf) over the leaves of the level, bitwise identical for any shares and threads.
template <class Term>
double parallel_sum(const Share& share, const Term& term) {
  std::vector<double> partial((share.size() + kParallelGrain - 1) / kParallelGrain, 0.0);
  parallel_for_chunks(share.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += term(share.begin + i);
    partial[begin / kParallelGrain] = sum;
  });
  return sum_of_all(share, partial);
}

}  // namespace crossgrain
