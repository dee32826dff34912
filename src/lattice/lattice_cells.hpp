// SPDX-License-Identifier: Apache-2.0
// Which cells of a lattice are kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "lattice/lattice_planes.hpp"

namespace crossgrain {

/// Share of a cell's volume from which it is kept.
inline constexpr double kKeptShare = 0.5;

struct KeptCells {
  std::vector<std::uint8_t> is_kept;  ///< of each cell, by the indices of volume_shares
  std::size_t toggled = 0;            ///< cells that are kept or left out against their share
  std::size_t faults = 0;             ///< vertices at which their surface still touches itself
};

/// Returns the cells of a lattice with half of their volume inside, changed until their surface is a
/// manifold: at each vertex those that are kept, and those that are not, are each connected by faces. Of the
/// cells around a vertex where that does not hold, the one whose share is nearest to a half changes, and each
/// change makes the next of the same cell dearer. Bodies far smaller than the largest (kLeastBody) are crumbs
/// and left out, unless their middle is in the box of one that small of the model, of `small_bodies()`, which
/// is called only where there are crumbs. The outermost cells must be outside.
KeptCells kept_cells(const std::vector<float>& shares, const LatticePlanes& planes,
                     const std::function<std::vector<Box>()>& small_bodies);

/// Bodies with a smaller share of the largest one's cells are left out.
inline constexpr double kLeastBody = 0.02;

}  // namespace crossgrain
