// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_messages.hpp"

#include <algorithm>
#include <utility>

namespace crossgrain {

SweepMessages::SweepMessages(const SweepHalo& halo, const SweepOrder& order, std::span<std::byte> values,
                             std::size_t size, std::span<std::uint8_t> awake)
    : halo_(halo),
      values_(values),
      size_(size),
      awake_(awake),
      events_before_(order.block_count()),
      parts_from_(order.block_count()),
      senders_left_(std::make_unique<std::atomic<std::uint32_t>[]>(halo.parts().size())),
      received_(halo.parts().size()) {
  std::vector<Exchange::Expected> expected;
  for (std::uint32_t p = 0; p < received_.size(); ++p) {
    const SweepHalo::Part& part = halo.parts()[p];
    senders_left_[p] = static_cast<std::uint32_t>(part.senders.size());
    for (const std::uint32_t block : part.senders) parts_from_[block].push_back(p);
    if (part.ghosts.empty()) continue;
    for (const std::uint32_t block : part.waiters) ++events_before_[block];
    received_[p].resize(part.ghosts.size() * size + (awake.empty() ? 0 : part.may_be_woken.size()));
    expected.push_back({part.rank, part.phase, received_[p]});
    expected_part_.push_back(p);
  }
  left_to_receive_ = expected.size();
  mailbox_ = halo.exchange().mailbox(expected);
}

std::vector<std::uint32_t> SweepMessages::occurred(bool is_idle) {
  send_ready();
  std::vector<std::uint32_t> blocks;
  for (const std::size_t message : mailbox_->arrived(is_idle && left_to_receive_ > 0)) {
    const std::uint32_t p = expected_part_[message];
    take(p);
    --left_to_receive_;
    const std::vector<std::uint32_t>& waiters = halo_.parts()[p].waiters;
    blocks.insert(blocks.end(), waiters.begin(), waiters.end());
  }
  return blocks;
}

void SweepMessages::ended(std::size_t block) {
  for (const std::uint32_t p : parts_from_[block]) {
    if (senders_left_[p].fetch_sub(1, std::memory_order_acq_rel) != 1) continue;
    const std::lock_guard lock(mutex_);
    ready_.push_back(p);
  }
}

void SweepMessages::finish() {
  send_ready();
  while (left_to_receive_ > 0) occurred(/*is_idle=*/true);
  mailbox_->finish();
}

void SweepMessages::send_ready() {
  std::vector<std::uint32_t> ready;
  {
    const std::lock_guard lock(mutex_);
    ready.swap(ready_);
  }
  for (const std::uint32_t p : ready) send(halo_.parts()[p]);
}

void SweepMessages::send(const SweepHalo::Part& part) {
  Bytes message;
  message.reserve(part.own.size() * size_ + (awake_.empty() ? 0 : part.wakes.size()));
  for (const std::uint32_t leaf : part.own) append_to<std::byte>(message, value(leaf));
  // A block of a later phase may wake a ghost meanwhile: that counts for its own message. Its block does not
  // run before all blocks of this one beside it that could have woken the ghost have told.
  if (!awake_.empty())
    for (const std::uint32_t ghost : part.wakes)
      message.push_back(
          static_cast<std::byte>(std::atomic_ref(awake_[ghost]).exchange(0, std::memory_order_relaxed)));
  mailbox_->send(part.rank, part.phase, std::move(message));
}

/// Copies what has come to the ghosts. No block that runs reads them: those of lower phases beside them have
/// run before these were sent, those of higher ones wait.
void SweepMessages::take(std::size_t p) {
  const SweepHalo::Part& part = halo_.parts()[p];
  const std::byte* next = received_[p].data();
  for (const std::uint32_t ghost : part.ghosts) {
    std::copy_n(next, size_, value(ghost).begin());
    next += size_;
  }
  if (awake_.empty()) return;
  for (const std::uint32_t leaf : part.may_be_woken)
    if (*next++ != std::byte{0}) std::atomic_ref(awake_[leaf]).store(1, std::memory_order_relaxed);
}

}  // namespace crossgrain
