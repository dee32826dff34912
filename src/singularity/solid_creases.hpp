// SPDX-License-Identifier: Apache-2.0
// The creases of a solid's surface, with the angle of solid at them, and the corners where they end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector3.hpp"

namespace crossgrain {

/// A chain of sharp edges without a branch or a sharp bend.
struct SolidCrease {
  struct Edge {
    std::array<std::uint32_t, 2> ends;

    /// The two triangles: the path through the solid from the first to the second is right-handed about the
    /// direction from the first end to the second.
    std::array<std::uint32_t, 2> triangles;
    double angle_deg;  ///< of the solid between them, from 0 to 360; 180 where the surface is flat
    double length;     ///< model units
  };
  std::vector<Edge> edges;
  double length = 0;          ///< model units
  double mean_angle_deg = 0;  ///< by length
  std::size_t sharpest = 0;   ///< edge of the least angle
};

/// A vertex where creases end.
struct SolidCorner {
  std::uint32_t vertex;
  std::vector<std::uint32_t> creases;  ///< in cyclic order around the vertex; twice if both ends are here
};

struct SolidCreases {
  std::vector<SolidCrease> creases;
  std::vector<SolidCorner> corners;  ///< without those where the surface is no single fan of triangles
};

/// A closed surface: triangles outward by the right-hand rule.
struct SolidSurface {
  std::span<const Vector3> vertices;
  std::span<const std::array<std::uint32_t, 3>> triangles;
  std::span<const std::int32_t> faces =
      {};  ///< of the model, of each triangle; empty if they have no numbers
  std::span<const std::int32_t> solids =
      {};  ///< of each triangle; empty where different solids share all triangles between them
};

/// Returns the creases: edges of two triangles that turn by more than 30 degrees, joined where two meet that
/// turn by less than 45. Edges of other numbers of triangles are none, nor are those where faces of two
/// solids lie on each other. Their order depends on the numbers of vertices only.
SolidCreases solid_creases(const SolidSurface& surface);

/// Smallest angle by which the surface turns at a crease: as on tets (tets/boundary_vertices.hpp).
constexpr double kSharpDeg = 30;

/// Unit normal of a triangle; {0, 0, 0} if it has no area.
Vector3 normal_of(const SolidSurface& surface, std::uint32_t triangle);

}  // namespace crossgrain
