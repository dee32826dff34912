// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arguments.hpp"

namespace crossgrain::app {

// Each runs a command with its arguments and throws Error on failure.

/// Solves and writes the field; prints a summary on standard output, progress on standard error. Returns the
/// exit code: that of an interruption if a stop left the field unfinished.
int run_solve(const SolveArguments& arguments);

/// Writes the frames at points; prints the number of points outside on standard error.
void run_sample(const SampleArguments& arguments);

/// Prints the singular lines and whether a hexahedral mesh can have them, on standard output.
void run_check(const CheckArguments& arguments);

/// Writes a picture; prints the time it took on standard output.
void run_render(const RenderArguments& arguments);
/// Serves the folder of a field to a browser; prints the address on standard output. Does not return: the
/// process becomes another program, or it throws.
[[noreturn]] void run_view(const ViewArguments& arguments);

/// Writes streamlines; prints a summary on standard output, the number of seeds outside on standard error.
void run_streamlines(const StreamlinesArguments& arguments);

/// Prints a spectrum on standard output.
void run_spectrum(const SpectrumArguments& arguments);

}  // namespace crossgrain::app
