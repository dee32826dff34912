// SPDX-License-Identifier: Apache-2.0
// An exchange on MPI. Only this folder includes its header.
#pragma once

#include <mpi.h>

#include <memory>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "crossgrain/processes.hpp"

namespace crossgrain {

/// Refers to a communicator. All calls are made by the thread that has initialised MPI.
class MpiExchange : public Exchange {
 public:
  explicit MpiExchange(MPI_Comm communicator);

  int rank() const override { return rank_; }
  int ranks() const override { return ranks_; }
  std::vector<Bytes> gathered(std::span<const std::byte> mine) override;
  std::vector<Bytes> delivered(std::vector<Bytes> to) override;
  void swap(std::span<const Sent> sent, std::span<const Received> received) override;
  std::unique_ptr<Mailbox> mailbox(std::span<const Expected> expected) override;

  /// What calls have taken so far, and the last mailbox. Waiting for other processes takes processor time
  /// too.
  const Processes::Work& work() const { return work_; }

 private:
  MPI_Comm communicator_;
  int rank_ = 0, ranks_ = 1;
  Processes::Work work_;
};

}  // namespace crossgrain
