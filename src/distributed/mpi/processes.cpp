// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/processes.hpp"

#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "distributed/level_shares.hpp"
#include "distributed/mpi/mpi_exchange.hpp"
#include "distributed/mpi/mpi_files.hpp"
#include "solve/shared_solve.hpp"
#include "solve/tuned_solve.hpp"

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
  LevelShares::Sizes finest;
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
                                           const SolveOptions& options, const Monitor& monitor,
                                           const CheckpointFolders& folders) {
  return TunedProcesses::solve(*this, earlier, mesh, SolveTuning(options), monitor, folders);
}

std::optional<FrameField> TunedProcesses::solve(Processes& processes, const FrameField* earlier,
                                                const TriangleMesh& mesh, const SolveTuning& options,
                                                const Monitor& monitor, const CheckpointFolders& folders) {
  Processes::State& state = *processes.state_;
  MpiFiles files(MPI_COMM_WORLD);
  KeptSolve checkpoint(state.exchange, files, folders.keep, folders.resume, folders.keep_seconds);
  LevelShares shares(state.exchange, equal_cuts, &checkpoint);
  std::optional<FrameField> field = solve_together(shares, earlier, mesh, options, monitor);
  state.finest = shares.last_share();
  return field;
}

std::vector<Processes::Work> Processes::work() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  Work mine = state_->exchange.work();
  mine.processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  mine.cells = state_->finest.own;
  mine.ghosts = state_->finest.ghosts;
  mine.peak_memory_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return gathered_value(state_->exchange, mine);
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
