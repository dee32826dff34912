// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain {

/// That a row may have a column.
struct AssignmentChoice {
  std::uint32_t row, column;
  double cost;  ///< 0 or more
};

/// Returns the column of each row, no two the same, so that the sum of their costs is least; UINT32_MAX for a
/// row without one, which costs `without`. By shortest augmenting paths (Jonker and Volgenant 1987).
std::vector<std::uint32_t> least_assignment(std::size_t rows, const std::vector<AssignmentChoice>& choices,
                                            double without);

}  // namespace crossgrain
