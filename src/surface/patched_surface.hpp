// SPDX-License-Identifier: Apache-2.0
// A surface cut along its creases into patches, which a mesher may cut into other triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "surface/crease_angles.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

struct PatchedSurface {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// For each triangle its patch, from 0: triangles connected over edges of no curve.
  std::vector<std::uint32_t> patch_of;

  /// For each patch the number of its face, if the surface has faces (TriangleMesh::faces); otherwise its own
  /// number from 1.
  std::vector<std::int32_t> tags;

  /// Curves between patches, and creases that fade out inside one, as chains of vertices between places where
  /// curves meet or bend. A closed one ends with its first vertex.
  std::vector<std::vector<std::uint32_t>> curves;

  /// For each curve, whether the surface is sharp there; borders between smooth faces are not.
  std::vector<bool> is_sharp;

  std::size_t patches() const { return tags.size(); }
};

/// Returns the surface with its patches: between its creases and, if it has them, its faces. Edges of one
/// triangle, or of three or more, are curves too. Vertices must be welded.
PatchedSurface patched(const Surface& surface, const CreaseAngles& angles);

}  // namespace crossgrain
