// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/processes.hpp"

#include <chrono>
#include <cstdlib>
#include <thread>

#include "distributed/level_shares.hpp"
#include "distributed/mpi/mpi_exchange.hpp"
#include "solve/shared_solve.hpp"

namespace crossgrain {

/// Initialises MPI first and finalises it last.
class Processes::State {
 public:
  State(int& argc, char**& argv) : session_(argc, argv), exchange(MPI_COMM_WORLD) {}

 private:
  struct Session {
    Session(int& argc, char**& argv) {
      int provided = 0;
      MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() { MPI_Finalize(); }
  };
  Session session_;

 public:
  MpiExchange exchange;
};

Processes::Processes(int& argc, char**& argv) : state_(std::make_unique<State>(argc, argv)) {}

Processes::~Processes() = default;

int Processes::rank() const {
  return state_->exchange.rank();
}

int Processes::count() const {
  return state_->exchange.ranks();
}

std::optional<FrameField> Processes::solve(const FrameField* earlier, const TriangleMesh& mesh,
                                           const SolveOptions& options, const Monitor& monitor) {
  LevelShares shares(state_->exchange);
  return solve_together(shares, earlier, mesh, options, monitor);
}

std::vector<std::string> Processes::gathered(const std::string& mine) {
  std::vector<std::string> all;
  for (const Bytes& part : state_->exchange.gathered(std::as_bytes(std::span(mine)))) {
    const std::vector<char> text = MessageReader(part).take<char>(part.size());
    all.emplace_back(text.begin(), text.end());
  }
  return all;
}

bool Processes::all_arrive(double seconds) {
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    int arrived = 0;
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (arrived) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

void Processes::abort(int exit_code) {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::_Exit(exit_code);
}

}  // namespace crossgrain
