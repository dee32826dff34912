// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "grid/cell_address.hpp"

namespace crossgrain {

/// Largest depth of the cells that a page shows: their corners count up to 2^16 along an axis.
inline constexpr int kDeepestShown = 16;

/// Constraint forms h^T A h - 2 b.h + c (docs/design.md, "Forms") of some cells, kept with a field for
/// display (SolveOptions::for_page). A cell is a leaf or the merged ancestor of several; its form is the
/// sum of those of its leaves, with areas in squared model units. One row per cell.
struct KeptForms {
  std::vector<CellAddress> cells;   ///< ascending
  std::vector<float> matrices;      ///< A, 28 or 45 numbers: the upper triangle row by row
  std::vector<float> linear_parts;  ///< b, 7 or 9 numbers; zero in degree 3
  std::vector<float> constants;     ///< c; zero in degree 3
  std::vector<float> weights;       ///< total area
};

}  // namespace crossgrain
