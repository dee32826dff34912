// SPDX-License-Identifier: Apache-2.0
#include "base/required_memory.hpp"

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// With less data no helper starts.
constexpr std::size_t kLeastHelperBytes = 8'000'000;

/// Less is not checked.
constexpr double kSmall = 1 << 20;

struct Demand {
  double needed, allowed;  ///< bytes

  bool is_met() const { return needed <= allowed; }
};

Demand demand_of(double more_bytes) {
  return {static_cast<double>(current_memory_bytes()) + more_bytes,
          static_cast<double>(allowed_memory_bytes(watched_memory_bytes()))};
}

}  // namespace

void require_memory(double more_bytes, const std::string& what, Remedy remedy, const std::string& file) {
  if (more_bytes < kSmall) return;
  const Demand demand = demand_of(more_bytes);
  if (demand.is_met()) return;
  throw Error(ErrorKind::kLimit, {file, "",
                                  fmt::format("{} takes {:.3g} GB of memory, and {:.3g} GB are allowed", what,
                                              demand.needed / 1e9, demand.allowed / 1e9),
                                  remedy});
}

bool has_memory_for(double more_bytes) {
  return more_bytes < kSmall || demand_of(more_bytes).is_met();
}

std::size_t memory_for_helper(std::size_t max_memory_bytes, const std::string& what,
                              const std::string& file) {
  const std::size_t most = allowed_memory_bytes(max_memory_bytes),
                    held = current_memory_bytes() + kHelperProgramBytes;
  if (held + kLeastHelperBytes <= most) return most - held;
  throw Error(ErrorKind::kLimit,
              {file, "",
               fmt::format("no memory is left {}: {:.3g} GB are allowed, and {:.3g} GB taken by the programs",
                           what, static_cast<double>(most) / 1e9, static_cast<double>(held) / 1e9),
               Remedy::kAllowMemory});
}

}  // namespace crossgrain
