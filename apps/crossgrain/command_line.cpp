// SPDX-License-Identifier: Apache-2.0
#include "command_line.hpp"

#include <memory>

#include "command_options.hpp"
#include "help_formatter.hpp"
#include "option_adders.hpp"
#include "version_text.hpp"

namespace crossgrain::app {
namespace {

constexpr const char* kExitCodes =
    "0 done; 1 a fault of the program; 2 wrong usage; 3 bad input; 4 output cannot be written; 5 a limit of "
    "memory, time or sweeps; 6 and 7 hex and fit: the best mesh is not what was asked for; 130 interrupted. "
    "The help of a "
    "command says more";

constexpr const char* kExitCodesOfProcesses =
    "0 done; 2 wrong usage; 3 bad input; 4 output cannot be written; 5 a limit of memory or sweeps; 130 "
    "interrupted. Other commands: crossgrain";

constexpr const char* kVersionHelp = "Print the version and what this build can do, and exit";

/// Flags take no values, but for the form of --progress: CLI11 takes those that look like a truth, and goes
/// on to take "true".
void refuse_values_of_flags(CLI::App& app) {
  for (CLI::App* const command : app.get_subcommands({}))
    for (CLI::Option* const option : command->get_options())
      if (option->get_items_expected_max() == 0 && !option->check_lname("progress"))
        option->disable_flag_override();
}

}  // namespace

CommandLine::CommandLine() : app("Volumetric octahedral frame fields", "crossgrain") {
  app.set_version_flag(
      "--version", [] { return version_text(Program::kOneProcess); }, kVersionHelp);
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(0, 1);
  solve_command = add_solve(app, solve);
  hex_command = add_hex(app, hex);
  fit_command = add_fit(app, fit);
  tets_command = add_tets(app, tets);
  sample_command = add_sample(app, sample);
  spectrum_command = add_spectrum(app, spectrum);
  check_command = add_check(app, check);
  streamlines_command = add_streamlines(app, streamlines);
  render_command = add_render(app, render);
  view_command = add_view(app, view);
  help_command = app.add_subcommand("help", "Prints the help of a command");
  help_command->add_option("COMMAND", explained, "The command (default: the program itself)");
  add_examples(*help_command, "crossgrain help\ncrossgrain help hex", "0 done; 2 no such command");
  app.footer(kExitCodes);
  refuse_values_of_flags(app);
}

CommandLineOfProcesses::CommandLineOfProcesses()
    : app("Volumetric octahedral frame fields, by several processes: mpirun -n 4 crossgrain-mpi solve MODEL",
          "crossgrain-mpi") {
  app.set_version_flag(
      "--version", [] { return version_text(Program::kProcesses); }, kVersionHelp);
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(1);
  solve_command = add_solve(app, solve);
  add_value(*solve_command, "--checkpoint", solve.checkpoint, "DIR",
            "Keep in this folder what is needed to go on after a break, whenever a shared level begins");
  add_number(*solve_command, "--checkpoint-minutes", solve.checkpoint_minutes, "N", 0,
             std::numeric_limits<double>::infinity(), "And so often within a level (default 10)");
  add_value(*solve_command, "--restart", solve.restart, "DIR",
            "Go on from the folder of --checkpoint, on any number of processes; give the same model "
            "and options");
  add_examples(*solve_command,
               "mpirun -n 4 crossgrain-mpi solve part.step --resolution 512\n"
               "mpirun -n 4 crossgrain-mpi solve part.step --checkpoint kept   # to go on after a break",
               kExitCodesOfProcesses);
  app.footer(kExitCodesOfProcesses);
  refuse_values_of_flags(app);
}

}  // namespace crossgrain::app
