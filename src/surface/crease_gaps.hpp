// SPDX-License-Identifier: Apache-2.0
// Edges less sharp than those of a crease that close its gaps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/crease_angles.hpp"
#include "surface/crease_network.hpp"

namespace crossgrain {

/// Radians: edges above may close gaps.
double least_turn_in_gaps(const CreaseAngles& angles);

/// Returns the edges above CreaseAngles::least_deg and those that close gaps between them, in the given
/// order. `edges` are all above `least_turn_in_gaps`. Where a path of sharp edges ends in the smooth surface
/// (at one of them, and not at one of the `holding` vertices), it goes on along other edges, at each vertex
/// along the one that bends least, by less than kCornerDeg; of equal ones the sharper one, then the one to
/// the lower vertex. They count if they come to a sharp edge, as straight if it is the end of one, or to a
/// holding vertex, as CreaseGaps says. The shortest gap is closed first, of equal ones that from the lower
/// vertex.
std::vector<SharpEdge> with_closed_gaps(std::vector<SharpEdge> edges, const std::vector<Vector3>& vertices,
                                        std::span<const std::uint32_t> holding, const CreaseAngles& angles);

}  // namespace crossgrain
