// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

struct ThreadArena;

/// Limits the number of threads of parallel loops that the current thread starts during the lifetime of the
/// object; 0 sets no limit. The smallest of nested limits applies. Results do not depend on it.
///
/// Concurrency: limits belong to the thread that creates them and do not affect loops of other threads; any
/// number of threads may hold limits at once. Destroy a limit on its own thread, in reverse order of
/// construction, as local variables are. Without a limit, loops run in the oneTBB arena of the calling
/// thread, whose size no limit exceeds.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  ThreadArena* before_;                 ///< what counts again when this ends
  std::unique_ptr<ThreadArena> arena_;  ///< none where an enclosing limit is as small
};

/// @}

}  // namespace crossgrain
