// SPDX-License-Identifier: Apache-2.0
// The most that a solve holds at a time, counted allocation by allocation.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "field/memory_budget.hpp"
#include "field/nested_solve.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace {

std::atomic<std::size_t> g_held{0}, g_most_held{0};

void* counted(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  const std::size_t size = malloc_usable_size(memory), held = g_held.fetch_add(size) + size;
  std::size_t most = g_most_held.load();
  while (held > most && !g_most_held.compare_exchange_weak(most, held)) {
  }
  return memory;
}

void release(void* memory) noexcept {
  if (memory != nullptr) g_held.fetch_sub(malloc_usable_size(memory));
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  return counted(std::aligned_alloc(step, (size + step - 1) / step * step));
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  release(memory);
}

namespace crossgrain {
namespace {

TEST(PeakMemory, OfAMillionCellsStaysWithinTheBudget) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers have allocators of their own";
#endif
  const testing::TestSolid part(make_bracket(48));
  SolveTuning options;
  options.resolution = 480;
  const std::size_t before = g_held.load();
  g_most_held.store(before);
  const SolvedField field = nested_solve(part.solid(), options, Monitor());
  const auto most = static_cast<double>(g_most_held.load() - before);
  const LevelCounts counts = LevelGrowth(field.level, part.solid()).after(0);
  const double budget = peak_memory_bytes(counts);
  RecordProperty("bytes_per_cell", std::to_string(most / counts.cells));
  std::printf("%.0f cells, %.1f bytes a cell of a budget of %.1f\n", counts.cells, most / counts.cells,
              budget / counts.cells);
  EXPECT_LT(most, budget + kMemoryOfOther);
  // A budget far above what is taken would refuse what fits.
  EXPECT_GT(most, 0.85 * budget);
}

}  // namespace
}  // namespace crossgrain
