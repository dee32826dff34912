// SPDX-License-Identifier: Apache-2.0
#include "display/shown_faces.hpp"

#include <algorithm>
#include <map>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

bool has_faces(const std::vector<std::int32_t>& numbers) {
  return std::any_of(numbers.begin(), numbers.end(), [](std::int32_t number) { return number != 0; });
}

}  // namespace

std::vector<std::int32_t> faces_near(const SearchableSurface& searched,
                                     const std::vector<std::int32_t>& faces,
                                     const std::vector<Vector3>& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (searched.surface().size() != faces.size()) return {};
  std::vector<std::int32_t> numbers(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t t) {
    const auto [a, b, c] = corners_of(triangles[t], vertices);
    numbers[t] = faces[searched.bvh().nearest((1.0 / 3) * (a + b + c)).triangle];
  });
  return numbers;
}

std::vector<std::int32_t> faces_of(const ShownField& field) {
  const SolvedSurface& surface = field.surface();
  if (has_faces(surface.faces)) return surface.faces;
  const auto solved = field.grid().surface.get();
  if (!field.is_on_tets() || !solved || !has_faces(solved->faces)) return {};
  return faces_near(*field.grid().surface.searchable(), solved->faces, surface.vertices, surface.triangles);
}

std::vector<std::int32_t> tags_of_sides(const HexMesh& mesh, const std::vector<HexSide>& sides) {
  const auto key = [](std::array<std::uint32_t, 4> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  std::map<std::array<std::uint32_t, 4>, std::int32_t> tags;
  for (const HexMesh::Face& face : mesh.boundary)
    if (face.tag != 0) tags.emplace(key(face.vertices), face.tag);
  if (tags.empty()) return {};
  std::vector<std::int32_t> result;
  result.reserve(sides.size());
  for (const HexSide& side : sides) {
    const auto found = tags.find(key(side.vertices));
    result.push_back(found == tags.end() ? 0 : found->second);
  }
  return result;
}

}  // namespace crossgrain
