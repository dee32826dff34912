// SPDX-License-Identifier: Apache-2.0
#include "measure/surface_quads.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "measure/hex_faces.hpp"

namespace crossgrain {

std::vector<SurfaceQuad> surface_quads(const HexMesh& mesh, std::span<const std::int32_t> solids) {
  std::vector<SurfaceQuad> quads;
  for (const HexSide& side : boundary_of(mesh)) quads.push_back({side.vertices, solids[side.hexahedron], 0});
  if (std::ranges::adjacent_find(solids, std::not_equal_to<>()) == solids.end()) return quads;
  for (const HexInnerFace& face : inner_faces_of(mesh)) {
    SurfaceQuad quad{face.vertices, solids[face.hexahedra[0]], solids[face.hexahedra[1]]};
    if (quad.below == quad.above) continue;
    if (quad.below < quad.above) {
      std::swap(quad.below, quad.above);
      std::ranges::reverse(quad.vertices);
    }
    quads.push_back(quad);
  }
  return quads;
}

}  // namespace crossgrain
