// SPDX-License-Identifier: Apache-2.0
#include "base/instruction_set.hpp"

#include <cstdlib>
#include <string>

namespace crossgrain {
namespace {

VectorWidth width_of_processor() {
#if defined(__x86_64__) && defined(__GNUC__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return VectorWidth::kEight;
  if (__builtin_cpu_supports("avx2")) return VectorWidth::kFour;
#endif
  return VectorWidth::kTwo;
}

/// Returns the width that CROSSGRAIN_VECTOR_DOUBLES allows: 2, 4 or 8.
VectorWidth width_allowed() {
  const char* setting = std::getenv("CROSSGRAIN_VECTOR_DOUBLES");
  const std::string doubles = setting == nullptr ? "" : setting;
  return doubles == "2" ? VectorWidth::kTwo : doubles == "4" ? VectorWidth::kFour : VectorWidth::kEight;
}

}  // namespace

VectorWidth vector_width() {
  static const VectorWidth width = std::min(width_of_processor(), width_allowed());
  return width;
}

}  // namespace crossgrain
