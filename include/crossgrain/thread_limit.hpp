// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Bounds the threads of the library's parallel loops while it lives; 0 means all that the machine has. Of
/// nested limits the smallest counts. Results do not depend on it. One thread at a time may hold limits.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

}  // namespace crossgrain
