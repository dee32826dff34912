// SPDX-License-Identifier: Apache-2.0
// How the frames of neighbouring tets match, and the edges around which they do not.
#pragma once

#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "singularity/matching.hpp"
#include "singularity/singular_edge.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The matching across each of TetSolid::inner_faces, from its first tet to its second; the identity where
/// there is no second. The way back is the inverse. `frames` has one entry a tet of the solid.
std::vector<CubeRotation> tet_matchings(const TetSolid& solid, std::span<const Quaternion> frames);

/// The edges inside the solid, with tets all around, around which the matchings compose to more than the
/// identity, in the order of the first such face at each. Points are the vertices that they use, ascending.
SingularEdges singular_tet_edges(const TetSolid& solid, std::span<const Quaternion> frames,
                                 std::span<const CubeRotation> matchings);

/// The same of the frames' own matchings.
SingularEdges singular_tet_edges(const TetSolid& solid, std::span<const Quaternion> frames);

}  // namespace crossgrain
