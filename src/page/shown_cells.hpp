// SPDX-License-Identifier: Apache-2.0
// Which cells a picture shows of a field that may have far more than can be drawn, and what the surface in
// some of them asks.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "field/cell_constraint.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Enough for every cell of a part at the default resolution.
inline constexpr std::size_t kMostShownCells = 200000;

/// Forms take ten times the bytes of all else that is known of a cell.
inline constexpr std::size_t kMostShownForms = 8000;

/// Corners of cells count up to 2^16 along an axis.
inline constexpr int kDeepestShown = 16;

/// The greatest depth, up to kDeepestShown, at which there are at most `most` cells when every deeper leaf is
/// merged with the others in its ancestor of that depth; 0 where there is none.
int shown_depth(const Octree& tree, std::size_t most = kMostShownCells);

/// The forms h^T A h - 2 b.h + c (docs/design.md section 3) of cells as they are shown: the sums of those of
/// their leaves, with areas in squared model units. A row a cell.
struct ShownForms {
  std::vector<CellAddress> cells;   ///< ascending
  std::vector<float> matrices;      ///< A, 28 or 45 numbers: the upper triangle row by row
  std::vector<float> linear_parts;  ///< b, 7 or 9 numbers; zero in degree 3
  std::vector<float> constants;     ///< c; zero in degree 3
  std::vector<float> weights;       ///< total area
};

/// Of at most `most` cells of shown_depth: first of all that ask for more than a plane, then of others,
/// evenly chosen in the order of the leaves.
ShownForms shown_forms(const GridLevel& level, const Solid& solid, Degree degree,
                       std::span<const CellConstraint> constraints, std::size_t most = kMostShownForms);

}  // namespace crossgrain
