// SPDX-License-Identifier: Apache-2.0
// What `--progress json` says, for other programs: an object a line (docs/command-line.md).
#pragma once

#include <string>

#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

// Each returns a line with its end; `seconds` count from the start of the program.
std::string json_line(const Progress& progress, double seconds);
std::string json_line(const ModelSummary& model, double seconds);
std::string json_line(const Expectation& expected, double seconds);
std::string json_line(const HexExpectation& expected, double seconds);
std::string json_line(const HexAttemptEnd& end, double seconds);

}  // namespace crossgrain::app
