// SPDX-License-Identifier: Apache-2.0
// Matchings between the frames of neighbouring tets, and the singular edges they imply.
#pragma once

#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "singularity/matching.hpp"
#include "singularity/singular_edge.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The matching across each of TetSolid::inner_faces, from its first tet to its second; the identity if there
/// is no second. The reverse matching is the inverse. `frames` has one entry per tet of the solid.
std::vector<CubeRotation> tet_matchings(const TetSolid& solid, std::span<const Quaternion> frames);

/// The singular edges inside the solid, with tets all around: those around which the product of the matchings
/// is not the identity, in the order of the first such face at each. Points are the vertices that they use,
/// ascending.
SingularEdges singular_tet_edges(const TetSolid& solid, std::span<const Quaternion> frames,
                                 std::span<const CubeRotation> matchings);

/// The singular edges for the matchings of these frames.
SingularEdges singular_tet_edges(const TetSolid& solid, std::span<const Quaternion> frames);

}  // namespace crossgrain
