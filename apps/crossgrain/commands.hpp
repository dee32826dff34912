// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arguments.hpp"

namespace crossgrain::app {

// Each does what its arguments say and throws Error where that fails.

/// Writes the field; a summary on standard output, progress on standard error. Returns the exit code: that of
/// an interruption where the field is one that a stop left unfinished.
int run_solve(const SolveArguments& arguments);

/// Writes the frames; the number of points outside on standard error.
void run_sample(const SampleArguments& arguments);

/// Prints what the singular lines are and whether hexahedra can have them, on standard output.
void run_check(const CheckArguments& arguments);

/// Writes the picture; how long that took on standard output.
void run_render(const RenderArguments& arguments);
/// Serves the folder of a field to a browser; the address on standard output. Returns only by throwing: the
/// process becomes another program.
[[noreturn]] void run_view(const ViewArguments& arguments);

/// Writes the lines; a summary on standard output, the number of seeds outside on standard error.
void run_streamlines(const StreamlinesArguments& arguments);

/// Prints the spectrum on standard output.
void run_spectrum(const SpectrumArguments& arguments);

}  // namespace crossgrain::app
