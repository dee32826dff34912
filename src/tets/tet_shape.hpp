// SPDX-License-Identifier: Apache-2.0
// Orientation of a tet, and whether it has volume.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

enum class TetShape : std::uint8_t {
  kPositive,   ///< (b - a) x (c - a) . (d - a) > 0 for vertices a, b, c, d
  kInverted,   ///< < 0
  kFlat,       ///< the four vertices are in one plane
  kCollapsed,  ///< a vertex is named twice
};

/// Limit of six volumes of a tet over its longest edge cubed, below which it is flat. Weights of linear
/// elements grow as the inverse, and beyond 1e12 energies would keep no more than four digits.
inline constexpr double kFlatness = 1e-12;

/// Shape of a tet. Coordinates must be below 1e100 (`check_vertices`), so that volumes do not overflow.
TetShape shape_of_tet(const std::vector<Vector3>& vertices, const std::array<std::uint32_t, 4>& tet);

/// 12 (3 V)^(2/3) over the sum of squared edges, with the sign of the volume V: 1 for a regular tet, 0 for a
/// flat one.
double mean_ratio(const std::array<Vector3, 4>& corners);

/// The volume of all tets.
double volume_of(const TetMesh& mesh);

Vector3 centroid_of_tet(const TetMesh& mesh, std::size_t tet);

/// The place of a vertex among the corners of a tet, 4 if it is none.
inline std::size_t corner_of(const std::array<std::uint32_t, 4>& tet, std::uint32_t vertex) {
  return static_cast<std::size_t>(std::find(tet.begin(), tet.end(), vertex) - tet.begin());
}

/// The corner of a tet that is no vertex of one of its faces.
inline std::size_t corner_opposite(const std::array<std::uint32_t, 4>& tet,
                                   const std::array<std::uint32_t, 3>& face) {
  std::size_t k = 0;
  while (std::find(face.begin(), face.end(), tet[k]) != face.end()) ++k;
  return k;
}

/// Vertices of the face opposite each corner, outward by the right-hand rule for a positive tet.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFaceCorners = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Corners of a tet for each edge, which joins the first two: the right-handed path around it goes through
/// the face opposite the third towards the one opposite the fourth. Also true with the first two and the last
/// two exchanged.
inline constexpr std::array<std::array<std::uint8_t, 4>, 6> kCornersAtEdges = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

}  // namespace crossgrain
