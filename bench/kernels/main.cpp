// SPDX-License-Identifier: Apache-2.0
// Measures the rates of the kernels on one core and the limits of the machine (docs/notes/performance.md,
// "Kernels"). bench/kernel_table.py runs it and makes a table.
//
//   kernels [--benchmark_filter=REGEX] [--benchmark_format=json] [options of Google Benchmark]
#include <benchmark/benchmark.h>

#include <cstdio>

#include "base/instruction_set.hpp"
#include "crossgrain/thread_limit.hpp"
#include "kernels/machine_limits.hpp"

namespace {

void add_context(const char* name, const char* format, double value) {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  benchmark::AddCustomContext(name, text);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace crossgrain;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const ThreadLimit one_thread(1);
  const bench::MachineLimits& limits = bench::machine_limits();
  add_context("copy_gigabytes_per_second", "%.2f", 1e-9 * limits.bytes_per_second);
  add_context("multiply_add_gigaflops", "%.2f", 1e-9 * limits.flops_per_second);
  add_context("vector_doubles", "%.0f", 2 << static_cast<int>(vector_width()));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
