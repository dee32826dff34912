// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_options.hpp"

#include <cmath>

#include "crossgrain/error.hpp"

namespace crossgrain {

void check_options(const HexOptions& options) {
  const auto demand = [](bool holds, const char* what) {
    if (!holds) throw Error(ErrorKind::kUsage, {"", "hexahedra", what});
  };
  demand(options.size >= 0 && std::isfinite(options.size), "their size must be a number from 0");
  demand(options.size > 0 || (options.cells > 0 && std::isfinite(options.cells)),
         "there must be a positive number of them along the longest side");
  demand(options.finer_sizes >= 0 && options.finer_share > 0 && options.finer_share < 1,
         "finer sizes must be shares between 0 and 1");
  demand(options.most_maps > 0, "there must be a map");
  demand(options.least_share >= 0 && options.least_share < 1, "the least share must be from 0 to below 1");
  demand(options.largest_gap > 0, "the largest gap must be positive");
}

}  // namespace crossgrain
