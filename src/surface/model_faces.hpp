// SPDX-License-Identifier: Apache-2.0
// The faces of a model as a table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/crease_angles.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Surfaces and tet meshes with more faces have no table: they are triangle soups or noise, where each patch
/// has a few triangles, and a table would be larger than the field.
inline constexpr std::size_t kMostListedFaces = 10000;

/// Adds up the triangles of faces.
class FaceTable {
 public:
  explicit FaceTable(FaceKind kind) : kind_(kind) {}

  /// `solids` as of a ModelFace; of several triangles the one that is 1 counts.
  void add(std::int64_t number, const std::array<Vector3, 3>& corners, std::uint32_t solids = 1);

  /// Ascending by number; none if there are more than kMostListedFaces.
  std::vector<ModelFace> faces() const;

 private:
  FaceKind kind_;
  std::map<std::int64_t, ModelFace> faces_;  ///< with the centre times the area
};

/// Returns for each triangle the number of its face: TriangleMesh::faces if the mesh has them, otherwise that
/// of its patch between creases, from 1 in the order of their first triangles; 0 if there are more than
/// kMostListedFaces.
std::vector<std::int32_t> face_numbers(const Surface& surface, const CreaseAngles& angles);

/// Returns the faces of triangles with these numbers; those of number 0 belong to none.
std::vector<ModelFace> listed_faces(const std::vector<Vector3>& vertices,
                                    const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    const std::vector<std::int32_t>& numbers, FaceKind kind);

/// Returns volume and area of closed triangles that look outward.
ModelSize size_of(const std::vector<Vector3>& vertices,
                  const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace crossgrain
