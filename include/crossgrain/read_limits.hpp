// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "crossgrain/monitor.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

class WatchedLoops;

/// Limits what reading files on the current thread may take during the lifetime of the object: memory of the
/// whole process, 0 for the limit that holds already, and time. Readers throw Error(kLimit) before they
/// exceed the memory, whatever a file inflates to, and Error(kInterrupted) within a second after the monitor
/// is stopped or cancelled; so does the constructor of TetDomain. Without a limit of memory, nine tenths of
/// what the machine or the container has.
///
/// Concurrency: like ThreadLimit, limits belong to their thread; the innermost counts. The monitor must
/// outlive the object.
class ReadLimits {
 public:
  explicit ReadLimits(const Monitor& monitor, std::size_t max_memory_bytes = 0);
  ~ReadLimits();
  ReadLimits(const ReadLimits&) = delete;
  ReadLimits& operator=(const ReadLimits&) = delete;

 private:
  std::unique_ptr<WatchedLoops> watched_;
};

/// @}

}  // namespace crossgrain
