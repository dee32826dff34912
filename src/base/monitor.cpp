// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/monitor.hpp"

#include "crossgrain/error.hpp"

namespace crossgrain {

void Monitor::check() const {
  if (cancelled() || (stopped() && heeds_stops())) throw Error(ErrorKind::kInterrupted, "interrupted");
}

}  // namespace crossgrain
