// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_patch.hpp"

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "base/vector3.hpp"
#include "fit/corner_shape.hpp"
#include "fit/vertex_surroundings.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_validity.hpp"

namespace crossgrain {
namespace {

void sort_once(std::vector<std::uint32_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

}  // namespace

HexPatch patch_around(std::uint32_t hexahedron, int layers, const HexMesh& mesh,
                      const Lists<std::uint32_t>& uses) {
  HexPatch patch{hexahedron, {hexahedron}, {}, {}};
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<std::uint32_t> more;
    for (const std::uint32_t h : patch.hexahedra)
      for (const std::uint32_t v : mesh.hexahedra[h])
        for (const std::uint32_t use : uses[v]) more.push_back(use / 8);
    sort_once(more);
    patch.hexahedra = std::move(more);
  }
  for (const std::uint32_t h : patch.hexahedra)
    patch.vertices.insert(patch.vertices.end(), mesh.hexahedra[h].begin(), mesh.hexahedra[h].end());
  sort_once(patch.vertices);
  for (const std::uint32_t v : patch.vertices) {
    patch.mesh.vertices.push_back(mesh.vertices[v]);
    patch.is_free.push_back(std::ranges::all_of(
        uses[v], [&](std::uint32_t use) { return std::ranges::binary_search(patch.hexahedra, use / 8); }));
  }
  for (const std::uint32_t h : patch.hexahedra)
    for (std::uint32_t& v : patch.mesh.hexahedra.emplace_back(mesh.hexahedra[h]))
      v = static_cast<std::uint32_t>(std::ranges::lower_bound(patch.vertices, v) - patch.vertices.begin());
  return patch;
}

double worst_scaled_jacobian(const HexMesh& mesh) {
  double worst = 1;
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    worst = std::min(worst, scaled_jacobian_of(corners_of(mesh, h)));
  return worst;
}

double poorness(const HexMesh& mesh, const std::vector<Vector3>& places, int power, double wanted,
                std::vector<Vector3>& gradient) {
  gradient.assign(places.size(), {0, 0, 0});
  double sum = 0;
  for (const auto& hexahedron : mesh.hexahedra) {
    HexCorners corners;
    for (std::size_t k = 0; k < 8; ++k) corners[k] = places[hexahedron[k]];
    for (std::size_t k = 0; k < 8; ++k) {
      const CornerShape shape(corners, k);
      if (!(shape.value > 0)) return INFINITY;
      const double term = raised(1 / shape.value, power), factor = -term / shape.value;
      sum += term;
      for (std::size_t n = 0; n < 3; ++n) {
        const double square = dot(shape.edges[n], shape.edges[n]);
        const double of_length = raised(wanted * wanted / square, power / 2);
        sum += of_length;
        const Vector3 of_edge = factor * shape.by_edge(n) - (of_length / square) * shape.edges[n];
        gradient[hexahedron[kHexNeighbours[k][n]]] += of_edge;
        gradient[hexahedron[k]] += -of_edge;
      }
    }
  }
  for (Vector3& of_place : gradient) of_place = (1 / sum) * of_place;
  return logarithm(sum) / power;
}

}  // namespace crossgrain
