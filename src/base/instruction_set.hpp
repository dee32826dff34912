// SPDX-License-Identifier: Apache-2.0
// Selects at run time the widest vectors that the processor has.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/parallel.hpp"

namespace crossgrain {

enum class VectorWidth : std::uint8_t { kTwo, kFour, kEight };  ///< in doubles

/// Returns the vector width of this processor, or less if the environment variable CROSSGRAIN_VECTOR_DOUBLES
/// is 2 or 4, so that results of different processors can be compared on one.
VectorWidth vector_width();

#if defined(__x86_64__) && defined(__GNUC__)

// `flatten` inlines everything that a kernel calls, so that all of it is compiled for these instructions.
template <class Kernel>
__attribute__((target("avx2"), flatten)) auto run_in_four_lanes(const Kernel& kernel) {
  return kernel.template operator()<4>();
}
template <class Kernel>
__attribute__((target("avx2,avx512f,avx512dq,avx512vl"), flatten)) auto run_in_eight_lanes(
    const Kernel& kernel) {
  return kernel.template operator()<8>();
}

/// Returns kernel.operator()<W>(), compiled for this processor; W is the number of Lanes (base/lanes.hpp)
/// that suits it. One call should process many cells.
template <class Kernel>
auto run_in_lanes(const Kernel& kernel) {
  switch (vector_width()) {
    case VectorWidth::kEight:
      return run_in_eight_lanes(kernel);
    case VectorWidth::kFour:
      return run_in_four_lanes(kernel);
    default:
      return kernel.template operator()<2>();
  }
}

#else

template <class Kernel>
auto run_in_lanes(const Kernel& kernel) {
  return kernel.template operator()<2>();
}

#endif

/// Calls visit.operator()<W>(begin, count) over [0, count) from several threads, compiled for this processor.
/// Each call gets W indices; the last one of a chunk may get fewer.
template <class Visit>
void parallel_for_lanes(std::size_t count, const Visit& visit) {
  parallel_for_chunks(count, kParallelGrain, [&](std::size_t begin, std::size_t end) {
    run_in_lanes([&]<int W>() {
      for (std::size_t i = begin; i < end; i += W)
        visit.template operator()<W>(i, static_cast<int>(std::min<std::size_t>(W, end - i)));
    });
  });
}

}  // namespace crossgrain
