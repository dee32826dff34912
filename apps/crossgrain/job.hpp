// SPDX-License-Identifier: Apache-2.0
// A run of `solve`, `hex` or `fit`, and what all of them do alike.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "arguments.hpp"
#include "commands.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/warning.hpp"
#include "progress_lines.hpp"

namespace crossgrain::app {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start);

struct Job {
  const SolveArguments& arguments;
  SolveOnGrid on_grid;
  const Monitor& monitor;
  std::function<void(const Warning&)> warn = [](const Warning&) {};  ///< of reading, before the solve
  /// Prints what was read, under a name.
  std::function<void(const char* what, const ModelSummary&)> tell = [](const char*, const ModelSummary&) {};
  ProgressLines* lines = nullptr;
  Clock::time_point start = Clock::now();

  /// Before a line is printed.
  void leave_line() const {
    if (lines != nullptr) lines->leave_line();
  }
};

/// Says on standard error what is written after a stop.
void announce_stop(const std::string& what_is_written);

/// Says whose result is replaced.
void announce_replaced(const Job& job);

/// What a run writes to its folder: it was checked before the work. What has appeared there since must not
/// cost the result, unless it would be lost.
OutputOptions output_options_for(const Job& job, const std::shared_ptr<FolderReservation>& reservation);

}  // namespace crossgrain::app
