// SPDX-License-Identifier: Apache-2.0
// The leaves around a point, for interpolation between cells.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/vector3.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {

/// The leaves that a cube around a point overlaps, as large as the leaf at the point, with their shares of
/// it. On cells of one size a mean with these shares interpolates linearly between the centres of cells; at
/// cells of another size it jumps by little.
struct LeafBlock {
  struct Part {
    CellIndex leaf;
    double share;  ///< of the cube's volume
  };
  std::array<Part, 8> parts;
  std::size_t count = 0;  ///< parts that are used, none if there is no leaf at the point

  std::span<const Part> used() const { return std::span(parts).first(count); }
};

/// Returns the block around a point. Leaves that are not connected to the one at the point within the block
/// are left out: they are across a gap. `open_faces` as in LeafConnections.
LeafBlock leaf_block(const Octree& tree, const LeafFinder& finder, std::span<const std::uint8_t> open_faces,
                     const Vector3& point);

}  // namespace crossgrain
