// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/monitor.hpp"

#include <array>

#include "base/names.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

const char* name_of(Phase phase) {
  constexpr std::array kNames{"read",  "grid",      "solve",  "analysis", "tets",
                              "write", "make tets", "repair", "hexahedra"};
  return name_among<Phase::kHexahedra>(kNames, phase);
}

void Monitor::check() const {
  if (cancelled()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

void Monitor::check_stop() const {
  if (cancelled() || stopped()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

}  // namespace crossgrain
