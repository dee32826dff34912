// SPDX-License-Identifier: Apache-2.0
#include "fit/near_surface.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "measure/hex_quality.hpp"

namespace crossgrain {
namespace {

/// Layers of hexahedra that are moved. With 3, 4 and 5 a lattice of 65,000 for wedge, and with 5 one of
/// 234,000 for pillow_block, have the worst scaled Jacobian and the mean of all layers within .01, and no
/// larger distances.
constexpr std::uint8_t kLayers = 4;

/// Share of all hexahedra that must be further inside: with less, the copy costs about what it saves.
constexpr double kLeastInside = 0.2;

/// For each hexahedron, how many layers are between it and those with a vertex on the surface or of a poor
/// one; at most kLayers.
std::vector<std::uint8_t> layers_of(const HexMesh& mesh, const HexCarriers& carriers, double poor) {
  std::vector<std::uint8_t> of_vertex(mesh.vertices.size(), kLayers);
  for (std::size_t v = 0; v < of_vertex.size(); ++v)
    if (carriers.of_vertex[v].is_on_surface()) of_vertex[v] = 0;
  const std::vector<double> shapes = scaled_jacobians(mesh);
  for (std::size_t h = 0; h < shapes.size(); ++h)
    if (shapes[h] < poor)
      for (const std::uint32_t v : mesh.hexahedra[h]) of_vertex[v] = 0;
  std::vector<std::uint8_t> of_hexahedron(mesh.hexahedra.size(), kLayers);
  for (std::uint8_t layer = 0; layer < kLayers; ++layer)
    for (std::size_t h = 0; h < of_hexahedron.size(); ++h) {
      const auto& corners = mesh.hexahedra[h];
      if (of_hexahedron[h] < kLayers ||
          std::ranges::none_of(corners, [&](std::uint32_t v) { return of_vertex[v] == layer; }))
        continue;
      of_hexahedron[h] = layer;
      for (const std::uint32_t v : corners)
        of_vertex[v] = std::min(of_vertex[v], static_cast<std::uint8_t>(layer + 1));
    }
  return of_hexahedron;
}

}  // namespace

void NearSurface::copy_places_to(HexMesh& whole) const {
  for (std::size_t v = 0; v < vertices.size(); ++v) whole.vertices[vertices[v]] = mesh.vertices[v];
}

std::optional<NearSurface> near_surface(const HexMesh& mesh, const HexCarriers& carriers, double poor) {
  const std::vector<std::uint8_t> layers = layers_of(mesh, carriers, poor);
  const auto inside = static_cast<double>(std::ranges::count(layers, kLayers));
  if (inside < kLeastInside * static_cast<double>(layers.size())) return std::nullopt;
  std::vector<std::uint8_t> is_near(mesh.vertices.size(), 0), is_inside(mesh.vertices.size(), 0);
  for (std::size_t h = 0; h < layers.size(); ++h)
    for (const std::uint32_t v : mesh.hexahedra[h]) (layers[h] < kLayers ? is_near : is_inside)[v] = 1;
  NearSurface part;
  std::vector<std::uint32_t> number(mesh.vertices.size(), 0);
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    if (!is_near[v]) continue;
    number[v] = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back(v);
    part.mesh.vertices.push_back(mesh.vertices[v]);
    part.carriers.of_vertex.push_back(is_inside[v] ? HexCarrier{HexCarrier::Kind::kHeld, 0}
                                                   : carriers.of_vertex[v]);
  }
  const auto renumber = [&](auto& vertices) {
    for (std::uint32_t& v : vertices) v = number[v];
  };
  for (std::size_t h = 0; h < layers.size(); ++h)
    if (layers[h] < kLayers) renumber(part.mesh.hexahedra.emplace_back(mesh.hexahedra[h]));
  part.carriers.path_of_curve = carriers.path_of_curve;
  for (auto& path : part.carriers.path_of_curve) renumber(path);
  part.carriers.group_of_face = carriers.group_of_face;
  part.carriers.quads = carriers.quads;
  for (HexCarriers::Quad& quad : part.carriers.quads) renumber(quad.vertices);
  return part;
}

}  // namespace crossgrain
