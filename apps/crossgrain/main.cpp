// SPDX-License-Identifier: Apache-2.0
// The command line program. Every error is one line on standard error and the exit code of its kind.
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "arguments.hpp"
#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "summary.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace crossgrain::app {
namespace {

struct Run {
  int operator()(const Finished& finished) const { return finished.exit_code; }
  int operator()(const SolveArguments& arguments) const { return run_solve(arguments); }
  int operator()(const TetsArguments& arguments) const { return run_tets(arguments), 0; }
  int operator()(const SampleArguments& arguments) const { return run_sample(arguments), 0; }
  int operator()(const SpectrumArguments& arguments) const { return run_spectrum(arguments), 0; }
  int operator()(const CheckArguments& arguments) const { return run_check(arguments), 0; }
  int operator()(const StreamlinesArguments& arguments) const { return run_streamlines(arguments), 0; }
  int operator()(const RenderArguments& arguments) const { return run_render(arguments), 0; }
  int operator()(const ViewArguments& arguments) const { run_view(arguments); }
};

/// Returns the file of a command, for errors that name none.
struct Subject {
  std::string operator()(const Finished&) const { return ""; }
  std::string operator()(const SolveArguments& arguments) const { return arguments.model; }
  std::string operator()(const TetsArguments& arguments) const { return arguments.model; }
  std::string operator()(const SampleArguments& arguments) const { return arguments.field; }
  std::string operator()(const SpectrumArguments&) const { return "spectrum"; }
  std::string operator()(const CheckArguments& arguments) const { return arguments.field; }
  std::string operator()(const StreamlinesArguments& arguments) const { return arguments.field; }
  std::string operator()(const RenderArguments& arguments) const { return arguments.field; }
  std::string operator()(const ViewArguments& arguments) const { return arguments.folder; }
};

Command command_of(const Arguments& arguments) {
  if (const auto* solve = std::get_if<SolveArguments>(&arguments)) return command_of(*solve);
  if (std::holds_alternative<TetsArguments>(arguments)) return Command::kTets;
  return Command::kOther;
}

int run(int argc, char** argv) {
  Arguments arguments = Finished{0};
  try {
    arguments = parse_arguments(argc, argv);
    return std::visit(Run(), arguments);
  } catch (const OutputClosed&) {
    // The end that the shell knows, now that nothing is left half written.
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
    return 1;
  } catch (...) {
    const Failure failure =
        failure_of(std::current_exception(), std::visit(Subject(), arguments), command_of(arguments));
    print_message(failure.line);
    return failure.exit_code;
  }
}

/// Ends the process where an exception cannot be caught: the library for JSON allocates in destructors.
/// Files are as after a kill.
[[noreturn]] void end_uncaught() {
  try {
    if (const std::exception_ptr exception = std::current_exception()) std::rethrow_exception(exception);
  } catch (const std::bad_alloc&) {
    // Without asking for memory.
    constexpr std::string_view kLine =
        "crossgrain: out of memory; close other programs, or simplify the model\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kLine.data(), kLine.size());
    std::_Exit(exit_code_of(ErrorKind::kLimit));
  } catch (...) {
  }
  std::abort();
}

}  // namespace
}  // namespace crossgrain::app

int main(int argc, char** argv) {
#ifdef M_MMAP_THRESHOLD
  // Returns large arrays to the system when a level is finished. By default the threshold grows with the
  // first large array that is freed, and a quarter of the peak is unused memory. With 128 KB small runs spend
  // a sixth of their time on pages of new arrays; with 4 and 8 MB in place of these they are 5 % faster
  // still, but hold 23 MB more, half of the peak of a small run.
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 2 * kMegabyte);
#endif
  std::set_terminate(crossgrain::app::end_uncaught);
  // A file that exceeds a limit of the system, and a pipe without a reader, should fail like any other write
  // error, not end the process.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  return crossgrain::app::run(argc, argv);
}
