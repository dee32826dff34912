// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "grid/share.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain::testing {

/// Cuts of shares (distributed/level_shares.hpp) at random blocks; every third share has no leaves.
inline std::vector<std::uint64_t> random_cuts(std::uint64_t leaves, int ranks) {
  RandomSamples random(static_cast<unsigned>(leaves % 1000) + static_cast<unsigned>(ranks));
  std::vector<std::uint64_t> cuts{0, leaves};
  for (int k = 1; k < ranks; ++k) {
    const auto place = static_cast<std::uint64_t>(random.uniform(0, 1) * static_cast<double>(leaves));
    cuts.push_back(k % 3 == 2 ? cuts.back() : place / kShareUnit * kShareUnit);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace crossgrain::testing
