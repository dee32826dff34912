// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "field/adjacency.hpp"
#include "field/octree_graph.hpp"

namespace crossgrain::testing {

/// What joins the leaves of a level through their faces as a list, each edge once.
inline std::vector<WeightedEdge> face_edges(const GridLevel& level, const LeafConnections& connections) {
  const std::vector<FaceNeighbours> neighbours = face_neighbours(level.tree);
  std::vector<WeightedEdge> edges;
  for (CellIndex i = 0; i < level.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      if (!(connections.open_faces[i] >> face & 1)) continue;
      const double steps = connections.weights[i][face].steps();
      edges.push_back({i, neighbours[i][face],
                       static_cast<float>(level.tree.cell_size(i) * steps / FaceWeight::kFullFace)});
    }
  }
  return edges;
}

}  // namespace crossgrain::testing
