// SPDX-License-Identifier: Apache-2.0
// `crossgrain solve` by several processes. Process 0 writes and prints, others help it.
#include <fmt/format.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.hpp"
#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/field_parts.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/processes.hpp"
#include "crossgrain/version.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "solve/tuned_solve.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace crossgrain::app {
namespace {

/// How long a process that fails waits for the others to fail alike, before it ends them.
constexpr double kSecondsForOthers = 2;

/// Another process has failed before the solve, and process 0 has told of it.
struct FailedElsewhere {
  int exit_code;
};

/// Brings the processes to the solve together, and to one exit code.
class Team {
 public:
  explicit Team(Processes& processes) : processes_(processes) {}

  /// Solves once all processes are ready. Throws FailedElsewhere if one is not.
  std::optional<FrameField> solve(const FrameField* earlier, const TriangleMesh& mesh,
                                  const SolveTuning& options, const Monitor& monitor,
                                  const CheckpointFolders& checkpoint) {
    if (const auto failure = first_failure({})) throw FailedElsewhere{failure->exit_code};
    has_begun_ = true;
    return TunedProcesses::solve(processes_, earlier, mesh, options, monitor, checkpoint);
  }

  /// Ends the work of this process, with a failure or without one. Returns the exit code of all.
  int end(const Failure& mine) {
    // Whoever has not failed waits for the others; they may wait in the middle of a solve for one that has.
    if (has_begun_ && !processes_.all_arrive(seconds_to_wait(mine.exit_code))) {
      print_message(of_rank(mine.line, processes_.rank()));
      processes_.abort(mine.exit_code);
    }
    const auto failure = first_failure(mine);
    return failure ? failure->exit_code : 0;
  }

 private:
  static double seconds_to_wait(int exit_code) {
    if (exit_code == 0) return std::numeric_limits<double>::infinity();
    // A second after it has passed on a signal, mpirun kills all processes.
    return exit_code == exit_code_of(ErrorKind::kInterrupted) ? 0 : kSecondsForOthers;
  }

  static std::string of_rank(const std::string& line, int rank) {
    return rank == 0 ? line : "process " + std::to_string(rank) + ": " + line;
  }

  /// Returns the failure of the lowest process that has failed; process 0 prints its line, unless it is
  /// empty.
  std::optional<Failure> first_failure(const Failure& mine) {
    const std::vector<std::string> codes = processes_.gathered(std::to_string(mine.exit_code));
    const std::vector<std::string> lines = processes_.gathered(mine.line);
    for (std::size_t rank = 0; rank < codes.size(); ++rank) {
      if (codes[rank] == "0") continue;
      if (processes_.rank() == 0 && !lines[rank].empty())
        print_message(of_rank(lines[rank], static_cast<int>(rank)));
      return Failure{std::stoi(codes[rank]), lines[rank]};
    }
    return std::nullopt;
  }

  Processes& processes_;
  bool has_begun_ = false;
};

/// Returns a number that other builds of the program hardly share.
std::string build_number() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325;
  std::vector<char> bytes(std::size_t{1} << 20);
  do {
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    for (std::streamsize i = 0; i < file.gcount(); ++i)
      hash = (hash ^ static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)])) * 0x100000001b3;
  } while (file);
  return fmt::format("{} (build {:x})", kVersion, hash);
}

/// Throws unless all processes run the same program.
void check_versions(Processes& processes) {
  const std::vector<std::string> versions = processes.gathered(build_number());
  for (std::size_t rank = 1; rank < versions.size(); ++rank) {
    if (versions[rank] != versions[0])
      throw Error(ErrorKind::kUsage, "process " + std::to_string(rank) + " runs " + versions[rank] +
                                         ", process 0 runs " + versions[0] +
                                         "; install one version on all hosts");
  }
}

/// Prints a table of the work of all processes.
void print_work(const std::vector<Processes::Work>& work) {
  print_result(
      "process      cells   ghosts  processor s  of it in MPI  s in MPI  of it in sweeps  messages a sweep  "
      "MB a sweep"
      "  MB sent  GB of memory\n");
  for (std::size_t rank = 0; rank < work.size(); ++rank) {
    const Processes::Work& w = work[rank];
    print_result(fmt::format(
        "{:7} {:10} {:8} {:12.2f} {:13.2f} {:9.2f} {:16.2f} {:17} {:11.2f} {:8.1f} {:13.3f}\n", rank, w.cells,
        w.ghosts, w.processor_seconds, w.processor_seconds_in_mpi, w.seconds_in_mpi,
        w.seconds_waiting_in_sweeps, w.messages_of_sweep, static_cast<double>(w.bytes_of_sweep) / 1e6,
        static_cast<double>(w.bytes_sent) / 1e6, static_cast<double>(w.peak_memory_bytes) / 1e9));
  }
}

/// Returns the exit code of this process's work, apart from failures.
int solve(Team& team, Processes& processes, const SolveArguments& arguments) {
  const CheckpointFolders checkpoint{arguments.checkpoint, 60 * arguments.checkpoint_minutes,
                                     arguments.restart};
  const SolveOnGrid together = [&](const FrameField* earlier, const TriangleMesh& mesh,
                                   const SolveTuning& options, const Monitor& monitor) -> GridField {
    std::optional<FrameField> field = team.solve(earlier, mesh, options, monitor, checkpoint);
    if (!field) return {};
    // Only the first process carries a field onto tets, or clips it.
    const bool has_tets = solves_tets(arguments) || !arguments.onto.empty();
    if (has_tets || arguments.output_options.clip) {
      const std::optional<FrameField> whole = whole_of_parts(*std::move(field));
      return {whole, whole};
    }
    return {field, arguments.page ? thinned_from_parts(*field, kMostCellsOfPage) : std::nullopt};
  };
  if (processes.rank() == 0) return run_solve(arguments, together);
  help_solve(arguments, together);
  return 0;
}

int run(Processes& processes, int argc, char** argv) {
  Team team(processes);
  std::string model;
  bool tells_work = false;
  Failure failure;
  try {
    check_versions(processes);
    const Arguments parsed = parse_arguments_of_processes(argc, argv);
    if (const auto* finished = std::get_if<Finished>(&parsed)) return finished->exit_code;
    const auto& arguments = std::get<SolveArguments>(parsed);
    model = arguments.model;
    tells_work = arguments.verbose;
    failure.exit_code = solve(team, processes, arguments);
  } catch (const FailedElsewhere& failed) {
    return failed.exit_code;
  } catch (const OtherProcessFailed&) {
    // That process tells of it.
  } catch (...) {
    failure = failure_of(std::current_exception(), model, Command::kProcesses);
    tells_work = false;
  }
  const int exit_code = team.end(failure);
  if (tells_work && exit_code == 0) {
    const std::vector<Processes::Work> work = processes.work();
    if (processes.rank() == 0) print_work(work);
  }
  return exit_code;
}

}  // namespace
}  // namespace crossgrain::app

int main(int argc, char** argv) {
#ifdef M_MMAP_THRESHOLD
  mallopt(M_MMAP_THRESHOLD, 1 << 20);  // as in crossgrain
  mallopt(M_TRIM_THRESHOLD, 2 << 20);
#endif
  std::signal(SIGXFSZ, SIG_IGN);
  crossgrain::Processes processes(argc, argv);
  // Help, results and the answer to Ctrl-C are those of process 0. The others go on until it ends them, so
  // that it does not wait for them.
  if (processes.rank() > 0)
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, SIG_IGN);
  if (processes.rank() > 0 && std::freopen("/dev/null", "w", stdout) == nullptr) processes.abort(1);
  return crossgrain::app::run(processes, argc, argv);
}
