// SPDX-License-Identifier: Apache-2.0
#include "surface/model_faces.hpp"

#include <algorithm>

#include "base/names.hpp"
#include "base/vector3.hpp"
#include "surface/patched_surface.hpp"

namespace crossgrain {

const char* name_of(FaceKind kind) {
  constexpr std::array kNames{"plane",      "cylinder", "cone",   "sphere", "torus", "extrusion",
                              "revolution", "spline",   "offset", "other",  "patch", "tagged"};
  return name_among<FaceKind::kTagged>(kNames, kind);
}

const char* name_of(ModelSource source) {
  constexpr std::array kNames{"tets", "surface", "cad"};
  return name_among<ModelSource::kCad>(kNames, source);
}

void FaceTable::add(std::int64_t number, const std::array<Vector3, 3>& corners, std::uint32_t solids) {
  const auto& [a, b, c] = corners;
  const double area = norm(cross(b - a, c - a)) / 2;
  const auto [place, is_new] = faces_.try_emplace(number, ModelFace{number, kind_, 0, {0, 0, 0}, solids});
  ModelFace& face = place->second;
  if (!is_new && solids == 1) face.solids = 1;
  face.area += area;
  face.centre += area / 3 * (a + b + c);
}

std::vector<ModelFace> FaceTable::faces() const {
  std::vector<ModelFace> faces;
  if (faces_.size() > kMostListedFaces) return faces;
  for (const auto& [number, sum] : faces_) {
    faces.push_back(sum);
    if (sum.area > 0) faces.back().centre = (1 / sum.area) * sum.centre;
  }
  return faces;
}

std::vector<std::int32_t> face_numbers(const Surface& surface, const CreaseAngles& angles) {
  if (!surface.mesh.faces.empty()) return surface.mesh.faces;
  const PatchedSurface patches = patched(surface, angles);
  if (patches.patches() > kMostListedFaces) return std::vector<std::int32_t>(surface.size(), 0);
  std::vector<std::int32_t> numbers;
  numbers.reserve(patches.patch_of.size());
  for (const std::uint32_t patch : patches.patch_of) numbers.push_back(patches.tags[patch]);
  return numbers;
}

std::vector<ModelFace> listed_faces(const std::vector<Vector3>& vertices,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    const std::vector<std::int32_t>& numbers, FaceKind kind) {
  FaceTable table(kind);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (numbers[t] != 0) table.add(numbers[t], corners_of(triangles[t], vertices));
  return table.faces();
}

ModelSize size_of(const std::vector<Vector3>& vertices,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  ModelSize size;
  if (triangles.empty()) return size;
  const Vector3& origin = vertices[triangles[0][0]];
  for (const auto& triangle : triangles) {
    const auto [a, b, c] = corners_of(triangle, vertices);
    size.volume += dot(a - origin, cross(b - origin, c - origin)) / 6;
    size.area += norm(cross(b - a, c - a)) / 2;
  }
  return size;
}

}  // namespace crossgrain
