// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace crossgrain {

/// Levels of at most so many cells are relaxed by so many sweeps, under a penalty for which a singular line
/// has a core of the size of a cell of `core_size`, or of its own cells where those are larger. So lines cost
/// the same in cells of all sizes, and are not drawn into the larger ones. Cells that lines have moved into
/// are refined again: grid and forms of these levels are made twice.
struct RelaxedLevels {
  std::size_t most_cells = 0;
  int sweeps = 0;
  double core_size = 0;  ///< model units
};

}  // namespace crossgrain
