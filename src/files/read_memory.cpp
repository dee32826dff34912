// SPDX-License-Identifier: Apache-2.0
#include "files/read_memory.hpp"

#include <fmt/format.h>

#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

void check_read_memory(const std::string& name, std::size_t file_bytes, double times,
                       std::size_t max_memory_bytes) {
  // Smaller files are not worth a query of the system.
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
