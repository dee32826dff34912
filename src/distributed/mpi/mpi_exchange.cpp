// SPDX-License-Identifier: Apache-2.0
#include "distributed/mpi/mpi_exchange.hpp"

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace crossgrain {
namespace {

/// MPI counts in int, so long messages go in parts.
constexpr std::size_t kLongestPart = std::size_t{1} << 30;

/// Tags of messages: they are matched in the order in which they are sent, so one is enough.
constexpr int kTag = 0;

/// Calls visit(first byte, number of bytes) for the parts of a message.
template <class Byte, class Visit>
void for_each_part(std::span<Byte> bytes, const Visit& visit) {
  for (std::size_t begin = 0; begin < bytes.size(); begin += kLongestPart)
    visit(bytes.data() + begin, static_cast<int>(std::min(kLongestPart, bytes.size() - begin)));
}

/// Adds the time of its life to a cost.
class CallTimer {
 public:
  explicit CallTimer(MpiExchange::Cost& cost)
      : cost_(cost), begin_(std::chrono::steady_clock::now()), processor_begin_(processor_seconds()) {}
  CallTimer(const CallTimer&) = delete;
  CallTimer& operator=(const CallTimer&) = delete;
  ~CallTimer() {
    ++cost_.calls;
    cost_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    cost_.processor_seconds += processor_seconds() - processor_begin_;
  }

 private:
  static double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  MpiExchange::Cost& cost_;
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

}  // namespace

MpiExchange::MpiExchange(MPI_Comm communicator) : communicator_(communicator) {
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &ranks_);
}

std::vector<Bytes> MpiExchange::gathered(std::span<const std::byte> mine) {
  const CallTimer timer(cost_);
  cost_.bytes_sent += mine.size() * static_cast<std::size_t>(ranks_ - 1);
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
  const CallTimer timer(cost_);
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
    cost_.bytes_sent += to[r].size();
  }
  from[static_cast<std::size_t>(rank_)] = std::move(to[static_cast<std::size_t>(rank_)]);
  requests.wait();
  return from;
}

void MpiExchange::swap(std::span<const Sent> sent, std::span<const Received> received) {
  const CallTimer timer(cost_);
  for (const Sent& message : sent) cost_.bytes_sent += message.bytes.size();
  Requests requests(communicator_);
  for (const Received& message : received) requests.receive(message.rank, message.bytes);
  for (const Sent& message : sent) requests.send(message.rank, message.bytes);
  requests.wait();
}

}  // namespace crossgrain
