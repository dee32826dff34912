// SPDX-License-Identifier: Apache-2.0
// The Dirichlet energy of linear elements on tets, as a sum over edges.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// An edge and its weight w = -sum over its tets of vol (grad phi_i . grad phi_j), phi_i the function that is
/// 1 at vertex i, 0 at the others and linear in every tet. Negative if the dihedral angles opposite the edge
/// are obtuse.
struct StiffnessEdge {
  std::uint32_t i, j;  ///< i < j
  double weight;       ///< model units of length
};

/// All edges of tets, ascending by (i, j), so that 1/2 integral |grad h|^2 = 1/2 sum w |h_i - h_j|^2 for h
/// linear in every tet. Tets must have volume and indices in range (`prepare_tets`); the orientation of a tet
/// does not matter. Bitwise identical for any number of threads.
std::vector<StiffnessEdge> stiffness_edges(const TetMesh& mesh);

}  // namespace crossgrain
