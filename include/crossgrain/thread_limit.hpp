// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace crossgrain {

struct ThreadArena;

/// Bounds the threads of the parallel loops that the calling thread starts while it lives; 0 means no bound
/// of its own. Of nested limits the smallest counts. Results do not depend on it.
///
/// Concurrency: each thread has limits of its own, which loops of other threads do not see: any number of
/// threads may hold limits at once, and each computes with as many threads as its own limit says. A limit
/// ends on the thread that made it, the last one first, as local variables do. Without a limit loops run in
/// the oneTBB arena of the calling thread, and no limit exceeds what that arena has.
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

}  // namespace crossgrain
