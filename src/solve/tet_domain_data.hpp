// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/tet_domain.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/inner_walls.hpp"
#include "tets/stiffness.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

struct TetDomainData {
  TetSolid solid;
  std::vector<StiffnessEdge> edges;
  std::vector<InnerWall> walls;
  InnerFeatures features;  ///< all walls and tagged edges
  BoundaryVertices boundary;
  Box box{};  ///< bounding box of the boundary
  double typical_edge_length = 0;
  std::vector<Warning> warnings;

  std::optional<MapPreparation> preparation;
  std::vector<std::uint32_t> parents;  ///< TetDomain::parents
};

}  // namespace crossgrain
