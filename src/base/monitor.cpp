// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/monitor.hpp"

#include "crossgrain/error.hpp"

namespace crossgrain {

void Monitor::check() const {
  if (cancelled()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

void Monitor::check_stop() const {
  if (cancelled() || stopped()) throw Error(ErrorKind::kInterrupted, "interrupted");
}

}  // namespace crossgrain
