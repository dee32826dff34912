// SPDX-License-Identifier: Apache-2.0
// A solve by several processes, on one machine or on many, through MPI. In the library crossgrain::processes,
// which is built where MPI is installed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/solve.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// Folders for going on after a break; empty for none.
struct CheckpointFolders {
  /// Takes what is needed to go on: whenever a shared level begins, and every so many seconds within it.
  std::string keep;
  double keep_seconds = 600;

  /// Left by an earlier solve of the same model with the same options, on any number of processes.
  std::string resume;
};

/// The processes that `mpirun` or a batch system has started together. One object per process, from which MPI
/// lives. All functions are called by all processes together, by the thread that made the object, unless said
/// otherwise.
class Processes {
 public:
  /// Initialises MPI.
  Processes(int& argc, char**& argv);

  /// Finalises MPI, which waits for the other processes.
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// Number of this process, from 0, and of all of them. Any process may ask.
  int rank() const;
  int count() const;

  /// Solves like `solve`, or `solve_from` if there is an earlier field, to the same bits. Levels of 200,000
  /// cells or more are shared: each process has a part of the cells, but the whole surface. If the last level
  /// was shared, each gets its part of the field (whole_of_parts joins them); otherwise process 0 gets the
  /// whole, and the others nothing. Throws like `solve`; some processes may throw and others wait for them,
  /// so whoever catches an error calls `all_arrive`, then `abort`. Only one process alone can be stopped at a
  /// finished level: several may have heard of a stop at different levels.
  std::optional<FrameField> solve(const FrameField* earlier, const TriangleMesh& mesh,
                                  const SolveOptions& options = {}, const Monitor& monitor = {},
                                  const CheckpointFolders& checkpoint = {});

  /// Returns what each process passed.
  std::vector<std::string> gathered(const std::string& mine);

  /// What the solves of one process have taken.
  struct Work {
    double processor_seconds = 0;  ///< of the whole process, calls of MPI included
    double seconds_in_mpi = 0;     ///< waiting included
    double processor_seconds_in_mpi = 0;
    double seconds_waiting_in_sweeps = 0;  ///< part of seconds_in_mpi
    std::uint64_t calls_of_mpi = 0, bytes_sent = 0;
    std::uint64_t messages_of_sweep = 0, bytes_of_sweep = 0;  ///< sent in the last sweep of the finest level
    std::uint64_t cells = 0, ghosts = 0;                      ///< of the finest level
    std::uint64_t peak_memory_bytes = 0;                      ///< of the whole process
  };

  /// Returns the work of each process.
  std::vector<Work> work();

  /// Returns whether all processes call this within so many seconds.
  bool all_arrive(double seconds);

  /// Ends all processes with this exit code. Any process may call it.
  [[noreturn]] void abort(int exit_code);

 private:
  friend struct TunedProcesses;  // of the library itself
  class State;
  std::unique_ptr<State> state_;
};

/// @}

}  // namespace crossgrain
