// SPDX-License-Identifier: Apache-2.0
#include "distributed/mpi/mpi_exchange.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <deque>
#include <utility>

namespace crossgrain {
namespace {

/// MPI counts in int, so long messages go in parts.
constexpr std::size_t kLongestPart = std::size_t{1} << 30;

/// Tag of messages that are matched in the order in which they are sent. Those of a mailbox have others.
constexpr int kTag = 0, kFirstMailboxTag = 1;

/// Calls visit(first byte, number of bytes) for the parts of a message.
template <class Byte, class Visit>
void for_each_part(std::span<Byte> bytes, const Visit& visit) {
  for (std::size_t begin = 0; begin < bytes.size(); begin += kLongestPart)
    visit(bytes.data() + begin, static_cast<int>(std::min(kLongestPart, bytes.size() - begin)));
}

/// Adds the time of its life to the work.
class CallTimer {
 public:
  explicit CallTimer(Processes::Work& work, bool is_of_mailbox = false)
      : work_(work),
        is_of_mailbox_(is_of_mailbox),
        begin_(std::chrono::steady_clock::now()),
        processor_begin_(processor_seconds()) {}
  CallTimer(const CallTimer&) = delete;
  CallTimer& operator=(const CallTimer&) = delete;
  ~CallTimer() {
    ++work_.calls_of_mpi;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin_;
    work_.seconds_in_mpi += seconds.count();
    if (is_of_mailbox_) work_.seconds_waiting_in_sweeps += seconds.count();
    work_.processor_seconds_in_mpi += processor_seconds() - processor_begin_;
  }

 private:
  static double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  Processes::Work& work_;
  const bool is_of_mailbox_;
  const std::chrono::steady_clock::time_point begin_;
  const double processor_begin_;
};

/// Messages under way.
class Requests {
 public:
  explicit Requests(MPI_Comm communicator) : communicator_(communicator) {}

  void send(int rank, std::span<const std::byte> bytes) {
    for_each_part(bytes, [&](const std::byte* first, int count) {
      MPI_Isend(first, count, MPI_BYTE, rank, kTag, communicator_, &requests_.emplace_back());
    });
  }
  void receive(int rank, std::span<std::byte> bytes) {
    for_each_part(bytes, [&](std::byte* first, int count) {
      MPI_Irecv(first, count, MPI_BYTE, rank, kTag, communicator_, &requests_.emplace_back());
    });
  }
  void wait() { MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

 private:
  MPI_Comm communicator_;
  std::vector<MPI_Request> requests_;
};

class MpiMailbox : public Mailbox {
 public:
  MpiMailbox(MPI_Comm communicator, std::span<const Exchange::Expected> expected, Processes::Work& work)
      : communicator_(communicator), work_(work) {
    const CallTimer timer(work_, /*is_of_mailbox=*/true);
    work_.messages_of_sweep = work_.bytes_of_sweep = 0;
    for (std::size_t message = 0; message < expected.size(); ++message) {
      parts_left_.push_back(0);
      for_each_part(expected[message].bytes, [&](std::byte* first, int count) {
        MPI_Irecv(first, count, MPI_BYTE, expected[message].rank, kFirstMailboxTag + expected[message].number,
                  communicator_, &receives_.emplace_back());
        message_of_.push_back(message);
        ++parts_left_.back();
      });
    }
    indices_.resize(receives_.size());
  }

  ~MpiMailbox() override {
    if (is_finished_) return;
    for (MPI_Request& request : receives_) {
      if (request == MPI_REQUEST_NULL) continue;
      MPI_Cancel(&request);
      MPI_Wait(&request, MPI_STATUS_IGNORE);
    }
    for (MPI_Request& request : sends_) MPI_Request_free(&request);
    // MPI may still read what it sends, so that memory is never given back.
    static_cast<void>(new std::deque<Bytes>(std::move(sent_)));
  }

  void send(int rank, int number, Bytes message) override {
    const CallTimer timer(work_, /*is_of_mailbox=*/true);
    work_.bytes_sent += message.size();
    work_.bytes_of_sweep += message.size();
    ++work_.messages_of_sweep;
    sent_.push_back(std::move(message));
    for_each_part(std::span<const std::byte>(sent_.back()), [&](const std::byte* first, int count) {
      MPI_Isend(first, count, MPI_BYTE, rank, kFirstMailboxTag + number, communicator_,
                &sends_.emplace_back());
    });
  }

  std::vector<std::size_t> arrived(bool may_wait) override {
    const CallTimer timer(work_, /*is_of_mailbox=*/true);
    int count = 0;
    (may_wait ? MPI_Waitsome : MPI_Testsome)(static_cast<int>(receives_.size()), receives_.data(), &count,
                                             indices_.data(), MPI_STATUSES_IGNORE);
    std::vector<std::size_t> messages;
    for (int k = 0; k < count; ++k) {  // count is MPI_UNDEFINED, which is negative, if all have come
      const std::size_t message =
          message_of_[static_cast<std::size_t>(indices_[static_cast<std::size_t>(k)])];
      if (--parts_left_[message] == 0) messages.push_back(message);
    }
    return messages;
  }

  void finish() override {
    const CallTimer timer(work_, /*is_of_mailbox=*/true);
    MPI_Waitall(static_cast<int>(sends_.size()), sends_.data(), MPI_STATUSES_IGNORE);
    is_finished_ = true;
  }

 private:
  MPI_Comm communicator_;
  Processes::Work& work_;
  std::vector<MPI_Request> receives_, sends_;
  std::vector<std::size_t> message_of_;  ///< of each receive
  std::vector<int> parts_left_;          ///< of each message
  std::vector<int> indices_;
  std::deque<Bytes> sent_;
  bool is_finished_ = false;
};

}  // namespace

std::unique_ptr<Mailbox> MpiExchange::mailbox(std::span<const Expected> expected) {
  return std::make_unique<MpiMailbox>(communicator_, expected, work_);
}

MpiExchange::MpiExchange(MPI_Comm communicator) : communicator_(communicator) {
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &ranks_);
}

std::vector<Bytes> MpiExchange::gathered(std::span<const std::byte> mine) {
  const CallTimer timer(work_);
  work_.bytes_sent += mine.size() * static_cast<std::size_t>(ranks_ - 1);
  const auto ranks = static_cast<std::size_t>(ranks_);
  const std::uint64_t size = mine.size();
  std::vector<std::uint64_t> sizes(ranks);
  MPI_Allgather(&size, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, communicator_);
  std::vector<Bytes> all(ranks);
  std::uint64_t total = 0;
  for (const std::uint64_t s : sizes) total += s;
  if (total < kLongestPart) {
    Bytes together(total);
    std::vector<int> counts(sizes.begin(), sizes.end()), begins(ranks);
    for (std::size_t r = 1; r < ranks; ++r) begins[r] = begins[r - 1] + counts[r - 1];
    MPI_Allgatherv(mine.data(), static_cast<int>(size), MPI_BYTE, together.data(), counts.data(),
                   begins.data(), MPI_BYTE, communicator_);
    for (std::size_t r = 0; r < ranks; ++r)
      all[r].assign(together.begin() + begins[r], together.begin() + begins[r] + counts[r]);
    return all;
  }
  for (std::size_t r = 0; r < ranks; ++r) {
    all[r].resize(sizes[r]);
    if (static_cast<int>(r) == rank_) std::copy(mine.begin(), mine.end(), all[r].begin());
    for_each_part(std::span(all[r]), [&](std::byte* first, int count) {
      MPI_Bcast(first, count, MPI_BYTE, static_cast<int>(r), communicator_);
    });
  }
  return all;
}

std::vector<Bytes> MpiExchange::delivered(std::vector<Bytes> to) {
  const CallTimer timer(work_);
  const auto ranks = static_cast<std::size_t>(ranks_);
  std::vector<std::uint64_t> sent(ranks), received(ranks);
  for (std::size_t r = 0; r < ranks; ++r) sent[r] = to[r].size();
  MPI_Alltoall(sent.data(), 1, MPI_UINT64_T, received.data(), 1, MPI_UINT64_T, communicator_);
  std::vector<Bytes> from(ranks);
  Requests requests(communicator_);
  for (std::size_t r = 0; r < ranks; ++r) {
    if (static_cast<int>(r) == rank_) continue;
    from[r].resize(received[r]);
    requests.receive(static_cast<int>(r), from[r]);
  }
  for (std::size_t r = 0; r < ranks; ++r) {
    if (static_cast<int>(r) == rank_) continue;
    requests.send(static_cast<int>(r), to[r]);
    work_.bytes_sent += to[r].size();
  }
  from[static_cast<std::size_t>(rank_)] = std::move(to[static_cast<std::size_t>(rank_)]);
  requests.wait();
  return from;
}

void MpiExchange::swap(std::span<const Sent> sent, std::span<const Received> received) {
  const CallTimer timer(work_);
  for (const Sent& message : sent) work_.bytes_sent += message.bytes.size();
  Requests requests(communicator_);
  for (const Received& message : received) requests.receive(message.rank, message.bytes);
  for (const Sent& message : sent) requests.send(message.rank, message.bytes);
  requests.wait();
}

}  // namespace crossgrain
