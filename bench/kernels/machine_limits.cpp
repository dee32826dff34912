// SPDX-License-Identifier: Apache-2.0
#include "kernels/machine_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include "base/instruction_set.hpp"
#include "guard/cpu_time.hpp"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>
#endif

namespace crossgrain::bench {
namespace {

constexpr int kRounds = 7;
constexpr std::size_t kCopiedBytes = std::size_t{256} << 20;
constexpr long kMultiplyAddSteps = 8'000'000;

/// Number of independent chains of multiply-adds: two units with a latency of four, and some more.
constexpr int kChains = 12;

/// Each step multiplies by this factor and adds a term that keeps the number near 1.
constexpr double kFactor = 0.999, kSummand = 0.001;

template <class Run>
double best_seconds(const Run& run) {
  double best = INFINITY;
  for (int round = 0; round < kRounds; ++round) best = std::min(best, cpu_seconds_of(run));
  return best;
}

double copy_bytes_per_second() {
  std::vector<char> from(kCopiedBytes, 1), to(kCopiedBytes, 0);
  const double seconds = best_seconds([&] {
    std::memcpy(to.data(), from.data(), kCopiedBytes);
    asm volatile("" : : "r"(to.data()) : "memory");  // prevents the compiler from removing copies
  });
  return 2.0 * kCopiedBytes / seconds;
}

#if defined(__x86_64__) && defined(__GNUC__)

__attribute__((target("avx512f"))) double multiply_add_in_eight_lanes() {
  __m512d chains[kChains];
  for (int k = 0; k < kChains; ++k) chains[k] = _mm512_set1_pd(k);
  const __m512d factor = _mm512_set1_pd(kFactor), summand = _mm512_set1_pd(kSummand);
  for (long step = 0; step < kMultiplyAddSteps; ++step) {
#pragma GCC unroll 12
    for (int k = 0; k < kChains; ++k) chains[k] = _mm512_fmadd_pd(chains[k], factor, summand);
  }
  double sum = 0;
  for (const __m512d& chain : chains) sum += chain[0];
  return sum;
}

__attribute__((target("avx2,fma"))) double multiply_add_in_four_lanes() {
  __m256d chains[kChains];
  for (int k = 0; k < kChains; ++k) chains[k] = _mm256_set1_pd(k);
  const __m256d factor = _mm256_set1_pd(kFactor), summand = _mm256_set1_pd(kSummand);
  for (long step = 0; step < kMultiplyAddSteps; ++step) {
#pragma GCC unroll 12
    for (int k = 0; k < kChains; ++k) chains[k] = _mm256_fmadd_pd(chains[k], factor, summand);
  }
  double sum = 0;
  for (const __m256d& chain : chains) sum += chain[0];
  return sum;
}

double multiply_add_in_two_lanes() {
  __m128d chains[kChains];
  for (int k = 0; k < kChains; ++k) chains[k] = _mm_set1_pd(k);
  const __m128d factor = _mm_set1_pd(kFactor), summand = _mm_set1_pd(kSummand);
  for (long step = 0; step < kMultiplyAddSteps; ++step) {
#pragma GCC unroll 12
    for (int k = 0; k < kChains; ++k) chains[k] = _mm_add_pd(_mm_mul_pd(chains[k], factor), summand);
  }
  double sum = 0;
  for (const __m128d& chain : chains) sum += chain[0];
  return sum;
}

#else

double multiply_add_in_two_lanes() {
  std::array<double, 2 * kChains> chains;
  chains.fill(1.5);
  for (long step = 0; step < kMultiplyAddSteps; ++step) {
    for (double& chain : chains) chain = chain * kFactor + kSummand;
  }
  double sum = 0;
  for (const double chain : chains) sum += chain;
  return sum;
}

#endif

struct MultiplyAddLoop {
  double (*run)();
  int lanes;
};

MultiplyAddLoop widest_loop() {
#if defined(__x86_64__) && defined(__GNUC__)
  if (vector_width() == VectorWidth::kEight) return {multiply_add_in_eight_lanes, 8};
  if (vector_width() == VectorWidth::kFour && __builtin_cpu_supports("fma"))
    return {multiply_add_in_four_lanes, 4};
#endif
  return {multiply_add_in_two_lanes, 2};
}

double multiply_add_flops_per_second() {
  const auto [run, lanes] = widest_loop();
  volatile double sink = 0;
  const double seconds = best_seconds([&, run = run] { sink = run(); });
  return 2.0 * lanes * kChains * kMultiplyAddSteps / seconds;
}

}  // namespace

const MachineLimits& machine_limits() {
  static const MachineLimits limits{copy_bytes_per_second(), multiply_add_flops_per_second()};
  return limits;
}

}  // namespace crossgrain::bench
