// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_map.hpp"

#include "hex/exact_map.hpp"

namespace crossgrain {
namespace {

HexMap::Corners seamless_corners(const CutSolid& cut, const MapCoordinates& map, std::uint32_t tet) {
  HexMap::Corners corners{};
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t k = 0; k < 3; ++k)
      corners[a][k] = map[static_cast<Eigen::Index>(3 * cut.copy_of(tet, a) + k)];
  return corners;
}

HexMap::Corners grid_corners(const ExactMap& map, std::uint32_t tet) {
  HexMap::Corners corners{};
  const std::array<ExactPoint, 4> exact = map.corners(tet);
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t k = 0; k < 3; ++k)
      corners[a][k] = static_cast<double>(exact[a][k]) / static_cast<double>(kGridUnit);
  return corners;
}

}  // namespace

HexMap hex_map_of(const MapUnknowns& unknowns, const IntegerGridMap& map, double size) {
  const ExactMap exact(unknowns, map.coordinates);
  const TetMesh& mesh = exact.solid().mesh;
  HexMap result{mesh.vertices, mesh.tets, {}, {}, size};
  result.seamless.reserve(mesh.tets.size());
  result.integer_grid.reserve(mesh.tets.size());
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    result.seamless.push_back(seamless_corners(exact.cut(), map.seamless_coordinates, t));
    result.integer_grid.push_back(grid_corners(exact, t));
  }
  return result;
}

}  // namespace crossgrain
