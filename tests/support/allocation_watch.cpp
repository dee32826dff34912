// SPDX-License-Identifier: Apache-2.0
#include "support/allocation_watch.hpp"

#include <dlfcn.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string_view>

namespace {

std::atomic<long> count = 0, failing_number = -1;
std::atomic<std::size_t> largest = 0;

/// Embree's own allocations do not fail: it does not survive that (docs/notes/faults.md).
bool is_spared(const void* caller) {
  Dl_info info{};
  return ::dladdr(caller, &info) != 0 && info.dli_fname != nullptr &&
         std::string_view(info.dli_fname).find("libembree") != std::string_view::npos;
}

}  // namespace

// Those of arrays and without exceptions call this one.
void* operator new(std::size_t size) {
  if (count.fetch_add(1, std::memory_order_relaxed) == failing_number &&
      !is_spared(__builtin_return_address(0)))
    throw std::bad_alloc();
  std::size_t before = largest.load(std::memory_order_relaxed);
  while (size > before && !largest.compare_exchange_weak(before, size, std::memory_order_relaxed)) continue;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace crossgrain {

void watch_allocations(long failing) {
  failing_number = -1;
  count = 0;
  largest = 0;
  failing_number = failing;
}

long allocation_count() {
  return count;
}

std::size_t largest_allocation() {
  return largest;
}

}  // namespace crossgrain
