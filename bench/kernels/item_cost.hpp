// SPDX-License-Identifier: Apache-2.0
// The results of a kernel: items per second on one core, and the share of the machine's limit.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>

#include "kernels/machine_limits.hpp"

namespace crossgrain::bench {

/// Minimal cost of one item: arithmetic counted from the formulas (additions, multiplications, divisions and
/// roots count one each; comparisons and copies nothing), and bytes of the data structures that a pass reads
/// or writes, each once.
struct ItemCost {
  double flops = 0;
  double bytes = 0;
};

/// Sets the counters of a benchmark on one thread, each iteration of which processes `items` items.
/// `share_of_limit` is the rate relative to the machine's limit: that of bandwidth or of multiply-adds,
/// whichever allows fewer items per second; the label names it. Times are CPU times.
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
