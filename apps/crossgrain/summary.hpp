// SPDX-License-Identifier: Apache-2.0
// What `solve` prints in the end, and how the program words an answer.
#pragma once

#include <string>

#include "arguments.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain::app {

/// Returns the summary of a solve, several lines: the answer about hexahedra and what to do next, then the
/// field and its cost, warnings, the energy and the files. Of tets it describes the field on them.
std::string summary_of(const SolveReport& report, const SolveArguments& arguments);

/// Returns a warning with what to do about it, in options of `solve` that suit the model.
std::string line_of(const Warning& warning, const SolveArguments& arguments);

/// Returns the sentence of an answer, with the program's options in what to do next.
std::string line_of(const Answer& answer);

/// Returns whether the warning says that the energy has not settled.
bool is_unsettled(const Warning& warning);

/// Returns whether the warning comes from reading a file, or from what is asked for: it is printed before the
/// work.
bool is_of_reading(const Warning& warning);

/// Returns whether the warning is printed even with --quiet: what was solved differs from the input or the
/// request, or the exit code needs an explanation.
bool is_always_printed(const Warning& warning);

}  // namespace crossgrain::app
