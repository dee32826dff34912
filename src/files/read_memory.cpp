// SPDX-License-Identifier: Apache-2.0
#include "files/read_memory.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

std::size_t allowed_memory_bytes(std::size_t max_memory_bytes) {
  constexpr double kShareOfMemory = 0.9;
  if (max_memory_bytes > 0) return max_memory_bytes;
  const std::size_t there = memory_limit_bytes();
  return there > 0 ? static_cast<std::size_t>(kShareOfMemory * static_cast<double>(there)) : SIZE_MAX;
}

void check_read_memory(const std::string& name, std::size_t file_bytes, double times,
                       std::size_t max_memory_bytes) {
  // Too little to be worth asking the system.
  constexpr std::size_t kSmall = std::size_t{1} << 24;
  if (file_bytes < kSmall) return;
  const auto allowed = static_cast<double>(allowed_memory_bytes(max_memory_bytes));
  const double needed = static_cast<double>(current_memory_bytes()) + times * static_cast<double>(file_bytes);
  if (needed <= allowed) return;
  throw Error(ErrorKind::kLimit,
              {name, "",
               fmt::format("reading its {:.3g} GB takes {:.3g} GB of memory, and {:.3g} GB are allowed",
                           static_cast<double>(file_bytes) / 1e9, needed / 1e9, allowed / 1e9),
               Remedy::kSimplifyOrAllowMemory});
}

}  // namespace crossgrain
