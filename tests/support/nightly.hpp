// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <string>

namespace crossgrain {

/// Returns whether a test takes all of its models, seeds or faults, and not those that stand for them by day.
inline bool is_nightly() {
  const char* const setting = std::getenv("CROSSGRAIN_NIGHTLY");
  return setting != nullptr && std::string(setting) == "1";
}

}  // namespace crossgrain
