// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace crossgrain {

/// What the surface in a cell asks of its frame (constraint/classification.hpp), as it is written to files.
enum class CellConstraint : std::uint8_t {
  kNoSurface = 0,
  kPlane = 1,
  kAxis = 2,
  kFrame = 3,
  kFree = 4,
  kConflicted = 5  ///< frames that are a compromise too
};
inline constexpr int kCellConstraintCount = 6;

}  // namespace crossgrain
