// SPDX-License-Identifier: Apache-2.0
#include "files/read_memory.hpp"

#include "base/parallel.hpp"
#include "base/required_memory.hpp"
#include "crossgrain/read_limits.hpp"

namespace crossgrain {

ReadLimits::ReadLimits(const Monitor& monitor, std::size_t max_memory_bytes)
    : watched_(std::make_unique<WatchedLoops>(monitor, Stops::kHeeded, max_memory_bytes)) {}

ReadLimits::~ReadLimits() = default;

void require_read_memory(const std::string& name, double more_bytes) {
  require_memory(more_bytes, "reading it", Remedy::kSimplifyOrAllowMemory, name);
}

}  // namespace crossgrain
