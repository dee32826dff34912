// SPDX-License-Identifier: Apache-2.0
// Isolated leaves that the surface barely cuts, and their ties to the rest of the solid.
#pragma once

#include <span>

#include "field/leaf_connector.hpp"
#include "field/octree_graph.hpp"

namespace crossgrain {

/// Ties the specks of a level. If it is shared, those of all processes, which call it together.
void tie_specks(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                const LeafConnector& connector, LeafConnections& connections);

}  // namespace crossgrain
