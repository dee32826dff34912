// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/octree.hpp"
#include "grid/share.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// On grids, largest distance between two ends on the surface from which one line goes on: a line that
/// touches the surface between cells has no edges there.
constexpr double kTouchCells = 3;

/// Pairs of ends of lines on a grid, at most kTouchCells apart, between which joined leaves lead: one line
/// may continue from one to the other along the surface. Not so across a gap in the solid. Nearest pairs
/// first, then by index. `singular` as from by_end_points, the same in all processes that share the tree;
/// `open_faces` as in LeafConnections.
std::vector<std::array<std::uint32_t, 2>> touching_ends(const SingularEdges& singular, const Octree& tree,
                                                        std::span<const std::uint8_t> open_faces,
                                                        const Share& part = {});

}  // namespace crossgrain
