// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace crossgrain::app {

enum class Program { kOneProcess, kProcesses };  ///< crossgrain, crossgrain-mpi

/// Returns what `--version` prints: name and version on a line of their own, then what this build can do on
/// this machine.
std::string version_text(Program program);

}  // namespace crossgrain::app
