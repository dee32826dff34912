// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "arguments.hpp"
#include "crossgrain/frame_field.hpp"
#include "crossgrain/solve.hpp"

namespace crossgrain {
struct SolveTuning;
}

namespace crossgrain::app {

/// A field on the grid, as one process writes it.
struct GridField {
  std::optional<FrameField> cells;  ///< those that this process writes; none: it writes none
  std::optional<FrameField> shown;  ///< a field for the page, in the first process
};

/// Computes the field on the grid, from an earlier one unless that is null.
using SolveOnGrid = std::function<GridField(const FrameField* earlier, const TriangleMesh& mesh,
                                            const SolveTuning& options, const Monitor& monitor)>;

// Each runs a command with its arguments and throws Error on failure.

/// Solves and writes the field; prints a summary on standard output, progress on standard error. Returns the
/// exit code: that of an interruption if a stop left the field unfinished. `together`, unless empty, solves
/// with other processes, and cannot be stopped at a finished level.
int run_solve(const SolveArguments& arguments, const SolveOnGrid& together = {});

/// Reads the same inputs as run_solve in another process, solves with it, and writes its cells.
/// Prints nothing.
void help_solve(const SolveArguments& arguments, const SolveOnGrid& together);

/// Cuts a model into tets and writes them; prints a summary on standard output, warnings and progress on
/// standard error.
void run_tets(const TetsArguments& arguments);

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
