// SPDX-License-Identifier: Apache-2.0
#include "base/instruction_set.hpp"

namespace crossgrain {
namespace {

VectorWidth find_vector_width() {
#if defined(__x86_64__) && defined(__GNUC__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return VectorWidth::kEight;
  if (__builtin_cpu_supports("avx2")) return VectorWidth::kFour;
#endif
  return VectorWidth::kTwo;
}

}  // namespace

VectorWidth vector_width() {
  static const VectorWidth width = find_vector_width();
  return width;
}

}  // namespace crossgrain
