// SPDX-License-Identifier: Apache-2.0
// What the sweeps of processes on their shares of one level send each other. There is a message for each
// phase and rank: it goes once the own blocks of the phase that have leaves for that rank are done, whatever
// others do. A block waits for the blocks of lower phases beside it only, and for the messages with those of
// other processes.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "field/sweep_halo.hpp"

namespace crossgrain {

/// The messages of one sweep. Tasks are blocks of the order.
class SweepMessages : public OutsideOfTasks {
 public:
  /// Copies values of own leaves to the ghosts of other processes, and those of theirs to the ghosts here.
  /// `awake`, unless empty, is 1 for leaves that a step has woken: ghosts tell their owners, and are 0
  /// afterwards. All must outlive the object.
  template <class T>
  SweepMessages(const SweepHalo& halo, const SweepOrder& order, std::span<T> values,
                std::span<std::uint8_t> awake)
      : SweepMessages(halo, order, std::as_writable_bytes(values), sizeof(T), awake) {}

  std::uint32_t events_before(std::size_t block) const override { return events_before_[block]; }
  std::vector<std::uint32_t> occurred(bool is_idle) override;
  void ended(std::size_t block) override;

  /// Sends and receives what is left, after all blocks.
  void finish();

 private:
  SweepMessages(const SweepHalo& halo, const SweepOrder& order, std::span<std::byte> values, std::size_t size,
                std::span<std::uint8_t> awake);

  std::span<std::byte> value(std::uint32_t leaf) const { return values_.subspan(leaf * size_, size_); }
  void send_ready();
  void send(const SweepHalo::Part& part);
  void take(std::size_t part);

  const SweepHalo& halo_;
  const std::span<std::byte> values_;
  const std::size_t size_;
  const std::span<std::uint8_t> awake_;
  std::vector<std::uint32_t> events_before_;            ///< for each block
  std::vector<std::vector<std::uint32_t>> parts_from_;  ///< for each block, parts that it is a sender of
  std::unique_ptr<std::atomic<std::uint32_t>[]> senders_left_;
  std::vector<Bytes> received_;               ///< for each part; empty if nothing comes
  std::vector<std::uint32_t> expected_part_;  ///< of each message that is expected
  std::size_t left_to_receive_ = 0;
  std::unique_ptr<Mailbox> mailbox_;

  std::mutex mutex_;
  std::vector<std::uint32_t> ready_;  ///< parts to send
};

}  // namespace crossgrain
