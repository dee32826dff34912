// SPDX-License-Identifier: Apache-2.0
// An exchange between threads of one process, in place of processes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "base/exchange.hpp"

namespace crossgrain::testing {

struct OtherRankFailed : std::runtime_error {
  OtherRankFailed() : std::runtime_error("another rank has failed") {}
};

/// Messages on their way from each rank to each other, in the order in which they were sent.
class Mail {
 public:
  explicit Mail(int ranks) : ranks_(ranks), boxes_(static_cast<std::size_t>(ranks * ranks)) {}

  int ranks() const { return ranks_; }

  void send(int from, int to, Bytes message) {
    const std::lock_guard lock(mutex_);
    box(from, to).push_back(std::move(message));
    changed_.notify_all();
  }

  Bytes receive(int from, int to) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_closed_ || !box(from, to).empty(); });
    if (box(from, to).empty()) throw OtherRankFailed();
    Bytes message = std::move(box(from, to).front());
    box(from, to).pop_front();
    return message;
  }

  /// Puts a message into a box of its own for each number.
  void send_numbered(int from, int to, int number, Bytes message) {
    const std::lock_guard lock(mutex_);
    numbered_[{from, to, number}].push_back(std::move(message));
  }

  /// Returns the message with a number, if it has come.
  std::optional<Bytes> taken(int from, int to, int number) {
    const std::lock_guard lock(mutex_);
    if (is_closed_) throw OtherRankFailed();
    const auto found = numbered_.find({from, to, number});
    if (found == numbered_.end()) return std::nullopt;
    Bytes message = std::move(found->second.front());
    found->second.pop_front();
    if (found->second.empty()) numbered_.erase(found);
    return message;
  }

  /// Ends all waits, since a rank has failed.
  void close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

 private:
  std::deque<Bytes>& box(int from, int to) { return boxes_[static_cast<std::size_t>(from * ranks_ + to)]; }

  int ranks_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::deque<Bytes>> boxes_;
  std::map<std::tuple<int, int, int>, std::deque<Bytes>> numbered_;  ///< by sender, receiver and number
  bool is_closed_ = false;
};

class ThreadMailbox : public Mailbox {
 public:
  ThreadMailbox(Mail& mail, int rank, std::span<const Exchange::Expected> expected)
      : mail_(mail), rank_(rank), expected_(expected.begin(), expected.end()), has_come_(expected.size()) {}

  void send(int rank, int number, Bytes message) override {
    mail_.send_numbered(rank_, rank, number, std::move(message));
  }

  std::vector<std::size_t> arrived(bool) override {
    std::vector<std::size_t> messages;
    for (std::size_t k = 0; k < expected_.size(); ++k) {
      if (has_come_[k]) continue;
      const auto& [rank, number, bytes] = expected_[k];
      const std::optional<Bytes> message = mail_.taken(rank, rank_, number);
      if (!message) continue;
      if (message->size() != bytes.size()) throw std::logic_error("a message has another size than expected");
      std::copy(message->begin(), message->end(), bytes.begin());
      has_come_[k] = true;
      messages.push_back(k);
    }
    return messages;
  }

  void finish() override {}

 private:
  Mail& mail_;
  const int rank_;
  const std::vector<Exchange::Expected> expected_;
  std::vector<bool> has_come_;
};

class ThreadExchange : public Exchange {
 public:
  ThreadExchange(Mail& mail, int rank) : mail_(mail), rank_(rank) {}

  int rank() const override { return rank_; }
  int ranks() const override { return mail_.ranks(); }

  std::vector<Bytes> gathered(std::span<const std::byte> mine) override {
    return delivered(std::vector<Bytes>(static_cast<std::size_t>(ranks()), Bytes(mine.begin(), mine.end())));
  }

  std::vector<Bytes> delivered(std::vector<Bytes> to) override {
    for (int r = 0; r < ranks(); ++r) mail_.send(rank_, r, std::move(to[static_cast<std::size_t>(r)]));
    std::vector<Bytes> from;
    for (int r = 0; r < ranks(); ++r) from.push_back(mail_.receive(r, rank_));
    return from;
  }

  void swap(std::span<const Sent> sent, std::span<const Received> received) override {
    for (const Sent& message : sent)
      mail_.send(rank_, message.rank, Bytes(message.bytes.begin(), message.bytes.end()));
    for (const Received& message : received) {
      const Bytes bytes = mail_.receive(message.rank, rank_);
      if (bytes.size() != message.bytes.size())
        throw std::logic_error("rank " + std::to_string(rank_) + " expected " +
                               std::to_string(message.bytes.size()) + " bytes of rank " +
                               std::to_string(message.rank) + ", not " + std::to_string(bytes.size()));
      std::copy(bytes.begin(), bytes.end(), message.bytes.begin());
    }
  }

  std::unique_ptr<Mailbox> mailbox(std::span<const Expected> expected) override {
    return std::make_unique<ThreadMailbox>(mail_, rank_, expected);
  }

 private:
  Mail& mail_;
  int rank_;
};

/// Runs work(exchange) for so many ranks, each on a thread of its own. Rethrows what the lowest failed rank
/// threw.
inline void run_ranks(int ranks, const std::function<void(Exchange& exchange)>& work) {
  Mail mail(ranks);
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(ranks));
  std::vector<std::thread> threads;
  for (int rank = 0; rank < ranks; ++rank)
    threads.emplace_back([&, rank] {
      ThreadExchange exchange(mail, rank);
      try {
        work(exchange);
      } catch (const OtherRankFailed&) {
        mail.close();
      } catch (...) {
        failures[static_cast<std::size_t>(rank)] = std::current_exception();
        mail.close();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace crossgrain::testing
