// SPDX-License-Identifier: Apache-2.0
#include "page/scene_hexahedra.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

#include "base/vector3.hpp"
#include "display/shown_faces.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "measure/hex_validity.hpp"
#include "page/scene_parts.hpp"

namespace crossgrain {
namespace {

/// The numbers of those to show, ascending.
std::vector<std::uint32_t> chosen(const HexMesh& mesh, const std::vector<double>& shapes, std::size_t most) {
  std::vector<std::uint32_t> numbers(mesh.hexahedra.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  if (numbers.size() <= most) return numbers;
  std::vector<std::uint8_t> is_inside(numbers.size(), 1);
  for (const HexSide& side : boundary_of(mesh)) is_inside[side.hexahedron] = 0;
  std::sort(numbers.begin(), numbers.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(is_inside[a], shapes[a], a) < std::tuple(is_inside[b], shapes[b], b);
  });
  numbers.resize(most);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// The tags of the six faces of each hexahedron, in the order of kHexFaces; empty if none has one.
std::vector<std::uint32_t> tags_of_faces(const HexMesh& mesh, const std::vector<std::uint32_t>& hexahedra) {
  std::vector<HexSide> sides;
  for (const std::uint32_t h : hexahedra) {
    for (const auto& corners : kHexFaces) {
      HexSide& side = sides.emplace_back(HexSide{{}, h});
      for (std::size_t k = 0; k < 4; ++k) side.vertices[k] = mesh.hexahedra[h][corners[k]];
    }
  }
  return column<std::uint32_t>(tags_of_sides(mesh, sides), [](std::int32_t tag) { return tag; });
}

}  // namespace

void add_hexahedra(const HexMesh& mesh, const Vector3& origin, std::size_t most, SceneWriter& scene) {
  if (mesh.hexahedra.empty()) return;
  const std::vector<double> shapes = scaled_jacobians(mesh);
  const std::vector<std::uint32_t> shown = chosen(mesh, shapes, most);
  constexpr std::uint32_t kUnused = UINT32_MAX;
  std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused), corners;
  std::vector<float> points;
  std::uint32_t used = 0;
  for (const std::uint32_t hexahedron : shown) {
    for (const std::uint32_t vertex : mesh.hexahedra[hexahedron]) {
      if (place[vertex] == kUnused) {
        place[vertex] = used++;
        for (std::size_t axis = 0; axis < 3; ++axis)
          points.push_back(static_cast<float>(mesh.vertices[vertex][axis] - origin[axis]));
      }
      corners.push_back(place[vertex]);
    }
  }
  scene.add("hex_points", 3, points);
  scene.add("hex_corners", 8, corners);
  scene.add("hex_shape", 1, column<float>(shown, [&](std::uint32_t h) { return shapes[h]; }));
  scene.add("hex_face", 6, tags_of_faces(mesh, shown));
  if (!mesh.regions.empty()) {
    std::vector<std::int32_t> regions;
    for (const std::uint32_t hexahedron : shown) regions.push_back(mesh.regions[hexahedron]);
    add_regions(regions, mesh.regions, "hex_region", "hex_regions", scene);
  }
  const std::vector<std::uint8_t> is_inverted = inverted_hexahedra(mesh);
  const auto inverted = std::ranges::count(is_inverted, 1);
  if (inverted > 0)
    scene.add("hex_inverted", 1,
              column<std::uint8_t>(shown, [&](std::uint32_t h) { return is_inverted[h]; }));
  if (shown.size() < shapes.size()) scene.add("hex_number", 1, shown);
  scene.header["hexahedra"] = {
      {"total", shapes.size()},
      {"shown", shown.size()},
      {"inverted", inverted},
      {"mean", std::accumulate(shapes.begin(), shapes.end(), 0.0) / static_cast<double>(shapes.size())}};
}

}  // namespace crossgrain
