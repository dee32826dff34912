// SPDX-License-Identifier: Apache-2.0

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"

namespace crossgrain {
namespace {

static_assert(static_cast<int>(Phase::kRepair) == CROSSGRAIN_REPAIRING);
static_assert(static_cast<int>(Phase::kSmooth) == CROSSGRAIN_SMOOTHING);

crossgrain_progress passed_on(const Progress& progress) {
  crossgrain_progress result{};
  result.phase = static_cast<crossgrain_phase>(progress.phase);
  result.depth = progress.depth;
  result.level = progress.level;
  result.levels = progress.levels;
  result.sweep = progress.sweep;
  result.cells = progress.cells;
  result.energy = progress.energy;
  result.share = progress.share;
  result.attempt = progress.attempt;
  result.tets = progress.tets;
  result.most_tets = progress.most_tets;
  result.hexahedra = progress.hexahedra;
  result.outcome = static_cast<crossgrain_hex_outcome>(progress.outcome);
  result.fitted = progress.fitted;
  return result;
}

crossgrain_expectation passed_on(const Expectation& expectation) {
  crossgrain_expectation result{};
  result.resolution = expectation.resolution;
  result.seconds = expectation.seconds;
  result.after_seconds = expectation.after_seconds;
  result.cells = expectation.active_cells;
  result.peak_memory_bytes = expectation.peak_memory_bytes;
  return result;
}

}  // namespace

const Monitor& monitor_of(const crossgrain_monitor* handle) {
  static const Monitor nobody;
  return handle == nullptr ? nobody : handle->monitor;
}

}  // namespace crossgrain

using namespace crossgrain;

crossgrain_monitor::crossgrain_monitor(crossgrain_on_progress on_progress,
                                       crossgrain_on_expectation on_expectation, void* state)
    : monitor(
          [this, on_progress, state](const Progress& progress) {
            const crossgrain_progress passed = passed_on(progress);
            if (on_progress != nullptr && on_progress(&passed, state) != 0) monitor.cancel();
          },
          [this, on_expectation, state](const Expectation& expectation) {
            const crossgrain_expectation passed = passed_on(expectation);
            if (on_expectation != nullptr && on_expectation(&passed, state) != 0) monitor.cancel();
          }) {}

crossgrain_status crossgrain_monitor_new(crossgrain_on_progress on_progress,
                                         crossgrain_on_expectation on_expectation, void* state,
                                         crossgrain_monitor** out, crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_monitor(on_progress, on_expectation, state); });
}

void crossgrain_monitor_free(crossgrain_monitor* monitor) {
  delete monitor;
}

void crossgrain_monitor_cancel(crossgrain_monitor* monitor) {
  if (monitor != nullptr) monitor->monitor.cancel();
}

void crossgrain_monitor_stop(crossgrain_monitor* monitor) {
  if (monitor != nullptr) monitor->monitor.stop();
}

void crossgrain_monitor_allow_stops(crossgrain_monitor* monitor) {
  if (monitor != nullptr) monitor->monitor.allow_stops();
}
