// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/monitor.hpp"

#include <array>
#include <utility>

#include "base/names.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

const char* name_of(Phase phase) {
  constexpr std::array kNames{"read",      "grid",   "solve", "analysis",  "tets",  "write",
                              "make tets", "repair", "map",   "hexahedra", "smooth"};
  return name_among<Phase::kSmooth>(kNames, phase);
}

Monitor::Monitor(const Monitor& whole, std::function<void(Progress&)> add)
    : whole_(&whole),
      on_progress_([&whole, add = std::move(add)](const Progress& progress) {
        Progress with_more = progress;
        add(with_more);
        whole.report(with_more);
      }),
      on_expectation_([&whole](const Expectation& expectation) { whole.expect(expectation); }),
      on_model_([&whole](const ModelSummary& model) { whole.tell(model); }) {}

void Monitor::check() const {
  if (cancelled()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

void Monitor::check_stop() const {
  if (cancelled() || stopped()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

}  // namespace crossgrain
