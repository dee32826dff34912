// SPDX-License-Identifier: Apache-2.0
// The command lines of the programs: all commands with their options and help. Parsing reads them;
// completions and man pages are made from them (documents/).
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "arguments.hpp"

namespace crossgrain::app {

/// The command line of `crossgrain`. Parsing `app` writes to the arguments of the command that was given.
struct CommandLine {
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  SolveArguments solve;
  SolveArguments hex;
  SolveArguments fit;
  TetsArguments tets;
  SampleArguments sample;
  SpectrumArguments spectrum;
  CheckArguments check;
  StreamlinesArguments streamlines;
  RenderArguments render;
  ViewArguments view;
  std::string explained;  ///< the command that `crossgrain help` is asked for

  CLI::App app;
  CLI::App* solve_command;
  CLI::App* hex_command;
  CLI::App* fit_command;
  CLI::App* tets_command;
  CLI::App* sample_command;
  CLI::App* spectrum_command;
  CLI::App* check_command;
  CLI::App* streamlines_command;
  CLI::App* render_command;
  CLI::App* view_command;
  CLI::App* help_command;
};

/// The same of `crossgrain-mpi`.
struct CommandLineOfProcesses {
  CommandLineOfProcesses();
  CommandLineOfProcesses(const CommandLineOfProcesses&) = delete;
  CommandLineOfProcesses& operator=(const CommandLineOfProcesses&) = delete;

  SolveArguments solve;
  CLI::App app;
  CLI::App* solve_command;
};

}  // namespace crossgrain::app
