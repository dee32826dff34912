// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/features.hpp"

#ifndef CROSSGRAIN_STD_THREADS
#include <oneapi/tbb/version.h>
#endif

#include "base/instruction_set.hpp"

namespace crossgrain {

int vector_doubles() {
  switch (vector_width()) {
    case VectorWidth::kEight:
      return 8;
    case VectorWidth::kFour:
      return 4;
    default:
      return 2;
  }
}

std::string instruction_set() {
#if defined(__x86_64__) && defined(__GNUC__)
  switch (vector_width()) {
    case VectorWidth::kEight:
      return "AVX-512";
    case VectorWidth::kFour:
      return "AVX2";
    default:
      return "SSE2";
  }
#else
  return "baseline";
#endif
}

std::string thread_library() {
#ifdef CROSSGRAIN_STD_THREADS
  return "std::thread";
#else
  return std::string("oneTBB ") + TBB_runtime_version();
#endif
}

}  // namespace crossgrain
