// SPDX-License-Identifier: Apache-2.0
// What `solve` prints in the end, and how the program words an answer.
#pragma once

#include <string>

#include "arguments.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/verdict.hpp"
#include "messages.hpp"

namespace crossgrain::app {

/// Returns the summary of a run, a row for each thing: of `hex` the hexahedra, the worst of them, how they
/// fit the model and the way to them; of `solve` the answer about hexahedra, the singular lines, the
/// alignment and the energy of the field, on tets if it has any; then warnings, with `verbose` all other
/// numbers, the files and the time. A new row is a function that returns it (`row`), and its place in the
/// list.
std::string summary_of(const SolveReport& report, const SolveArguments& arguments);

/// Returns the rows of `hex` and `fit` about the hexahedra in a folder: outcome, shapes, fit, features, way,
/// warnings and where faces are numbered.
std::string rows_of_mesh(const SolveReport& report, const std::string& folder);

/// Returns the command whose arguments these are: `solve`, `hex` or `fit`.
Command command_of(const SolveArguments& arguments);

/// Returns a warning with what to do about it, in options of the command that suit the model.
std::string line_of(const Warning& warning, const SolveArguments& arguments);

/// Returns the sentence of an answer, with options of the program in what to do next.
std::string line_of(const Answer& answer, Command command);

/// Returns the sentence about hexahedra likewise.
std::string line_of(const HexReport& hexahedra, const SolveArguments& arguments);

/// Returns whether the warning says that the energy has not settled.
bool is_unsettled(const Warning& warning);

/// Returns whether the warning comes from reading a file, or from what is asked for: it is printed before the
/// work.
bool is_of_reading(const Warning& warning);

/// Returns what to expect of hexahedra: "about 97 hexahedra of 3.05, along a field on 12561 tets of 17.1
/// (--tet-size)", with the rule for the size of tets if that was not followed.
std::string sentence_of(const HexExpectation& expected);

/// Whether the first row of the summary says it, that solids touch or overlap.
bool is_said(const Warning& warning, const SolveReport& report);

/// Returns whether the warning is printed even with --quiet: what was solved differs from the input or the
/// request, or the exit code needs an explanation.
bool is_always_printed(const Warning& warning);

}  // namespace crossgrain::app
