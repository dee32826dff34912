// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace crossgrain {

/// A point or a direction, in the model's own length unit.
using Vector3 = std::array<double, 3>;

/// An axis-aligned box; empty when some `low` exceeds its `high`.
struct Box {
  Vector3 low;
  Vector3 high;
};

/// A surface: triangles that index vertices. Nothing is required of it but that indices are in range and
/// coordinates are finite; it may be open, flipped, non-manifold or a soup.
struct TriangleMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A solid cut into tets that index vertices, of either orientation.
struct TetMesh {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;
};

/// Three orthonormal axes, right-handed. As an octahedral frame it stands for itself and the 23 other
/// rotations that permute the axes and flip their signs.
struct Frame {
  std::array<Vector3, 3> axes;
};

/// Degree of the spherical harmonics that carry a frame: 3 (octupoles, seven numbers) or 4 (nine numbers).
enum class Degree : int { kThree = 3, kFour = 4 };

}  // namespace crossgrain
