// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace crossgrain::app {

/// Runs each job at once in a thread of its own, so that connections which send nothing delay no other.
/// Threads are kept for later jobs.
class ConnectionThreads {
 public:
  /// Starts at most so many threads.
  explicit ConnectionThreads(std::size_t most) : most_(most) {}
  ~ConnectionThreads() { finish(); }
  ConnectionThreads(const ConnectionThreads&) = delete;
  ConnectionThreads& operator=(const ConnectionThreads&) = delete;

  /// Runs a job. Waits for a thread to become free if there are as many jobs as threads may be.
  void run(std::function<void()> job);

  /// Waits for all jobs to end.
  void finish();

 private:
  void work();
  bool add_thread();

  const std::size_t most_;
  std::mutex mutex_;
  std::condition_variable job_came_, thread_is_free_;
  std::deque<std::function<void()>> jobs_;
  std::vector<std::thread> threads_;
  std::size_t free_ = 0;  ///< threads without a job
  bool is_over_ = false;
};

}  // namespace crossgrain::app
