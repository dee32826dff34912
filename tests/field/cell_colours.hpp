// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "field/field_graph.hpp"

namespace crossgrain::testing {

/// The colour of each cell.
inline std::vector<std::uint8_t> colours_of(const Colouring& colouring) {
  std::vector<std::uint8_t> colours(colouring.cells.size());
  for (std::size_t colour = 0; colour < colouring.colour_count(); ++colour) {
    for (std::size_t k = colouring.begin[colour]; k < colouring.begin[colour + 1]; ++k)
      colours[colouring.cells[k]] = static_cast<std::uint8_t>(colour);
  }
  return colours;
}

}  // namespace crossgrain::testing
