// SPDX-License-Identifier: Apache-2.0
#include "view/connection_threads.hpp"

#include <system_error>
#include <utility>

namespace crossgrain::app {

void ConnectionThreads::run(std::function<void()> job) {
  std::unique_lock lock(mutex_);
  if (jobs_.size() >= free_ && !add_thread()) {
    if (threads_.empty()) {
      lock.unlock();
      return job();
    }
    thread_is_free_.wait(lock, [this] { return jobs_.size() < free_; });
  }
  jobs_.push_back(std::move(job));
  job_came_.notify_one();
}

/// Returns false if there are as many threads as there may be, or the system starts no more.
bool ConnectionThreads::add_thread() {
  if (threads_.size() >= most_) return false;
  try {
    threads_.emplace_back([this] { work(); });
  } catch (const std::system_error&) {
    return false;
  }
  ++free_;
  return true;
}

void ConnectionThreads::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    job_came_.wait(lock, [this] { return !jobs_.empty() || is_over_; });
    if (jobs_.empty()) return;
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    --free_;
    lock.unlock();
    job();
    lock.lock();
    ++free_;
    thread_is_free_.notify_one();
  }
}

void ConnectionThreads::finish() {
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
  }
  job_came_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

}  // namespace crossgrain::app
