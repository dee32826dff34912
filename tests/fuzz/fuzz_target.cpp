// SPDX-License-Identifier: Apache-2.0
// The fuzz target of one reader: CROSSGRAIN_READER_CHECK is its check, given by CMake, which also defines
// CROSSGRAIN_ANY_ALLOCATION where it computes (ReaderUnderTest::computes).
#include <sanitizer/allocator_interface.h>
#include <sanitizer/common_interface_defs.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "crossgrain/thread_limit.hpp"
#include "fuzz/reader_checks.hpp"

namespace {

constexpr std::size_t kAnything = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> most_allowed = kAnything;

void watch_allocation(const volatile void*, std::size_t size) {
  if (size <= most_allowed) return;
  most_allowed = kAnything;
  std::fprintf(stderr, "ERROR: %zu bytes taken at once, which no bytes of the file stand behind\n", size);
  __sanitizer_print_stack_trace();
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // The same edges are counted each time then.
  static const crossgrain::ThreadLimit one_thread(1);
  __sanitizer_install_malloc_and_free_hooks(watch_allocation, [](const volatile void*) {});
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
#ifndef CROSSGRAIN_ANY_ALLOCATION
  most_allowed = crossgrain::most_allocated_at_once(bytes);
#endif
  crossgrain::CROSSGRAIN_READER_CHECK(bytes);
  most_allowed = kAnything;
  return 0;
}
