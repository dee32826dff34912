// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "crossgrain/tet_domain.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/inner_walls.hpp"
#include "tets/stiffness.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// What a TetDomain holds.
struct TetDomainData {
  TetSolid solid;
  std::vector<StiffnessEdge> edges;
  std::vector<InnerWall> walls;
  InnerFeatures features;  ///< walls and tagged edges; none of it left out
  BoundaryVertices boundary;
  Box box{};  ///< of the boundary
  double typical_edge_length = 0;
  std::vector<Warning> warnings;
};

}  // namespace crossgrain
