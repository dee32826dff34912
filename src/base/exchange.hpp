// SPDX-License-Identifier: Apache-2.0
// What the processes that solve one field together need of each other. All of them call the same functions in
// the same order. src/distributed has one on MPI, tests have one on threads; a process that is alone needs
// none.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/interface.hpp"

namespace crossgrain {

using Bytes = std::vector<std::byte>;

void append_bytes(Bytes& message, std::span<const std::byte> bytes);

template <class T>
void append_to(Bytes& message, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  append_bytes(message, std::as_bytes(values));
}

/// Appends the values and their number.
template <class T>
void append_list(Bytes& message, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  append_to<std::uint64_t>(message, {&count, 1});
  append_to<T>(message, values);
}

/// Takes values from a message in the order in which they were appended.
class MessageReader {
 public:
  explicit MessageReader(std::span<const std::byte> message) : left_(message) {}

  /// Throws std::logic_error if fewer values are left, since then processes have not called the same
  /// functions.
  template <class T>
  std::vector<T> take(std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count * sizeof(T) > left_.size()) throw std::logic_error("a message is shorter than expected");
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), left_.data(), count * sizeof(T));
    left_ = left_.subspan(count * sizeof(T));
    return values;
  }
  template <class T>
  T take() {
    return take<T>(1).front();
  }
  template <class T>
  std::vector<T> take_list() {
    return take<T>(take<std::uint64_t>());
  }
  bool empty() const { return left_.empty(); }
  std::size_t size() const { return left_.size(); }

 private:
  std::span<const std::byte> left_;
};

/// Messages that go and come while a process does other work. Destroyed without `finish`, it gives up what is
/// under way.
class Mailbox : public Interface {
 public:
  /// Sends a message, and returns at once. `number` tells it from others to this rank.
  virtual void send(int rank, int number, Bytes message) = 0;

  /// Returns which of the expected messages have come since the last call. May wait for one if `may_wait`;
  /// then some must be left.
  virtual std::vector<std::size_t> arrived(bool may_wait) = 0;

  /// Waits until all messages have been sent. All expected ones must have arrived.
  virtual void finish() = 0;
};

class Exchange : public Interface {
 public:
  /// Number of this process, from 0, and of all of them.
  virtual int rank() const = 0;
  virtual int ranks() const = 0;

  /// Returns what each rank passed, by rank.
  virtual std::vector<Bytes> gathered(std::span<const std::byte> mine) = 0;

  /// Sends to[r] to rank r, and returns what each rank sent to this one.
  virtual std::vector<Bytes> delivered(std::vector<Bytes> to) = 0;

  /// A message of known size to or from a rank.
  struct Sent {
    int rank;
    std::span<const std::byte> bytes;
  };
  struct Received {
    int rank;
    std::span<std::byte> bytes;
  };

  /// Sends and receives; returns once all has come and may be overwritten. There is at most one message from
  /// a rank to another, and both give the same size for it. Ranks without messages may leave out the call.
  virtual void swap(std::span<const Sent> sent, std::span<const Received> received) = 0;

  /// A message of known size and number that a rank will send.
  struct Expected {
    int rank;
    int number;
    std::span<std::byte> bytes;
  };

  /// Returns a box for these messages, and for those that this process sends, with the same numbers as the
  /// others expect. Only one is in use at a time, and only the thread that uses the exchange uses it.
  virtual std::unique_ptr<Mailbox> mailbox(std::span<const Expected> expected) = 0;
};

/// Returns the values that all ranks passed, those of rank 0 first.
template <class T>
std::vector<T> gathered_values(Exchange& exchange, std::span<const T> mine) {
  std::vector<T> all;
  for (const Bytes& part : exchange.gathered(std::as_bytes(mine))) {
    const std::vector<T> values = MessageReader(part).take<T>(part.size() / sizeof(T));
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}
template <class T>
std::vector<T> gathered_value(Exchange& exchange, const T& mine) {
  return gathered_values<T>(exchange, std::span<const T>(&mine, 1));
}

/// Moves the values of all ranks to the first, in the order of the ranks; others have none afterwards.
template <class T>
std::vector<T> moved_to_first(Exchange& exchange, std::vector<T> values) {
  std::vector<Bytes> to(static_cast<std::size_t>(exchange.ranks()));
  append_to(to.front(), std::span<const T>(values));
  values = std::vector<T>();
  std::vector<Bytes> from = exchange.delivered(std::move(to));
  for (Bytes& part : from) {
    const std::vector<T> more = MessageReader(part).take<T>(part.size() / sizeof(T));
    part = Bytes();
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

bool any(Exchange& exchange, bool mine);

/// Returns the terms of all ranks added to zero one after the other, those of rank 0 first: the same to the
/// bit for any shares.
double running_sum(Exchange& exchange, std::span<const double> terms);

}  // namespace crossgrain
