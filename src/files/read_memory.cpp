// SPDX-License-Identifier: Apache-2.0
#include "files/read_memory.hpp"

#include <fmt/format.h>

#include "base/parallel.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/read_limits.hpp"

namespace crossgrain {
namespace {

/// Of ReadLimits; 0 for the usual share of the machine.
thread_local std::size_t t_max_memory = 0;

}  // namespace

ReadLimits::ReadLimits(const Monitor& monitor, std::size_t max_memory_bytes)
    : watched_(std::make_unique<WatchedLoops>(monitor, Stops::kHeeded)), memory_before_(t_max_memory) {
  if (max_memory_bytes > 0) t_max_memory = max_memory_bytes;
}

ReadLimits::~ReadLimits() {
  t_max_memory = memory_before_;
}

void require_read_memory(const std::string& name, double more_bytes) {
  constexpr double kSmall = 1 << 24;
  if (more_bytes < kSmall) return;
  const auto allowed = static_cast<double>(allowed_memory_bytes(t_max_memory));
  const double needed = static_cast<double>(current_memory_bytes()) + more_bytes;
  if (needed <= allowed) return;
  throw Error(ErrorKind::kLimit,
              {name, "",
               fmt::format("reading it takes {:.3g} GB of memory, and {:.3g} GB are allowed", needed / 1e9,
                           allowed / 1e9),
               Remedy::kSimplifyOrAllowMemory});
}

}  // namespace crossgrain
