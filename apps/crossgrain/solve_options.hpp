// SPDX-License-Identifier: Apache-2.0
// Options that `solve`, `hex` and `fit` share.
#pragma once

#include "arguments.hpp"

namespace CLI {
class App;
}

namespace crossgrain::app {

void add_folder(CLI::App& command, SolveArguments& arguments, const char* help);

/// Creases, threads, memory, seed, and how solids are read.
void add_run_options(CLI::App& command, SolveArguments& arguments);

void add_keep_tags(CLI::App& command, TetTagOptions& options);

/// --write; with the formats of maps, if the command makes hexahedra.
void add_formats(CLI::App& command, OutputOptions& options, bool has_map);

/// What is written of hexahedra that are inverted, and which exit code approximate ones have.
void add_outcomes(CLI::App& command, SolveArguments& arguments);

/// Whether a page is written.
void add_page(CLI::App& command, SolveArguments& arguments);

/// What is printed, and whether a page is written.
void add_talk(CLI::App& command, SolveArguments& arguments);

}  // namespace crossgrain::app
