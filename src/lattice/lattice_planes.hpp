// SPDX-License-Identifier: Apache-2.0
// Planes that a lattice is cut by.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "surface/surface.hpp"

namespace crossgrain {

/// Coordinates of the planes normal to each axis, ascending.
struct LatticePlanes {
  std::array<std::vector<double>, 3> at;

  std::size_t cells(std::size_t axis) const { return at[axis].size() - 1; }
  std::size_t cells() const { return cells(0) * cells(1) * cells(2); }
};

/// What gets planes besides large faces that are apart.
struct NarrowPlanes {
  bool walls = false;  ///< both sides of walls and gaps, however thin
  std::vector<Box> holes =
      {};  ///< both sides of boxes that are narrower than two sizes, unless others are near
};

/// Returns planes about `size` apart around a surface: those of its large faces normal to an axis first,
/// where these are not too near to each other (kLeastGap); then those of what is narrow; the same number of
/// others between two of them as fit best; and on either side one that the surface does not reach.
LatticePlanes lattice_planes(const Surface& surface, double size, const NarrowPlanes& narrow = {});

/// Least distance of planes on faces, in sizes.
inline constexpr double kLeastGap = 0.45;

/// Least distance of planes at holes from others, in sizes.
inline constexpr double kHoleGap = 0.15;

/// Least area of faces in a plane that gets one, in squared sizes.
inline constexpr double kPlaneArea = 0.7;

}  // namespace crossgrain
