// SPDX-License-Identifier: Apache-2.0
// What a kernel reports: items a second on one core, and how near that comes to what the machine can do.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>

#include "kernels/machine_limits.hpp"

namespace crossgrain::bench {

/// What one item takes at least, whatever the code: arithmetic counted from the formulas (additions,
/// multiplications, divisions and roots one each; comparisons and copies nothing), and bytes of the data
/// structures that a pass reads or writes, each once.
struct ItemCost {
  double flops = 0;
  double bytes = 0;
};

/// Counters of a benchmark on one thread of which each iteration does `items` items. `share_of_limit` is the
/// part of the machine's limit that the rate reaches: of bandwidth or of multiply-adds, whichever allows
/// fewer items a second; the label says which. Times are CPU times.
inline void report(benchmark::State& state, std::size_t items, const ItemCost& cost) {
  using benchmark::Counter;
  const double by_memory = cost.bytes / machine_limits().bytes_per_second;
  const double by_arithmetic = cost.flops / machine_limits().flops_per_second;
  const double least_seconds = std::max(by_memory, by_arithmetic);
  const double count = static_cast<double>(items);
  state.counters["items_per_second"] = Counter(count, Counter::kIsIterationInvariantRate);
  state.counters["flops_per_item"] = cost.flops;
  state.counters["bytes_per_item"] = cost.bytes;
  state.counters["share_of_limit"] = Counter(count * least_seconds, Counter::kIsIterationInvariantRate);
  state.SetLabel(by_memory >= by_arithmetic ? "memory" : "arithmetic");
}

}  // namespace crossgrain::bench
