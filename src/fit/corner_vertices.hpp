// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "fit/corner_exits.hpp"

namespace crossgrain {

/// The vertices and exits of all corners.
struct CornerVertices {
  std::vector<std::uint32_t> vertices;  ///< kNowhere without
  std::vector<CornerExits> exits;       ///< empty ones without
};

/// Returns vertices of the same solids near the corners, no two the same, with the least sum of costs:
/// distance in sizes, missing edges, turns of exits, and normals of two solids that disagree.
CornerVertices corner_vertices(const HexMesh& mesh, const QuadComplex& surface,
                               const FeatureComplex& features, const SolidSets& sets, double size);

}  // namespace crossgrain
