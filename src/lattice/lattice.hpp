// SPDX-License-Identifier: Apache-2.0
// Hexahedra of a lattice that roughly fill a model.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/types.hpp"
#include "lattice/holes.hpp"
#include "lattice/lattice_planes.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// What gets planes of its own although it is narrower than the size. Each has what those before it have.
enum class NarrowLevel {
  kNothing,
  kWalls,  ///< both sides of thin walls and gaps, those beside holes too
  kHoles,  ///< both sides of holes, slots and bosses that are narrower than two sizes
  kRings   ///< what is around these, for thin walls that are not flat
};

struct NarrowFeatures {
  NarrowLevel level = NarrowLevel::kNothing;

  /// Holes, slots and bosses, from which their boxes along the lattice's axes are found.
  std::vector<Hole> holes = {};

  std::vector<FinePlace> fine = {};  ///< places with planes nearer to each other, as the surface lies

  /// Points of lines, such as the border of a fillet, that lie in a plane each if they can.
  std::vector<std::vector<Vector3>> lines = {};
};

struct Lattice {
  HexMesh mesh;              ///< with its boundary, without tags
  Quaternion axes;           ///< lattice_axes
  NarrowLevel level{};       ///< of what has planes
  double slanted_share = 0;  ///< of the area of the surface, what is in no plane of a lattice (slanted_share)
  std::size_t toggled = 0;   ///< KeptCells
  std::vector<int> shells;   ///< euler_numbers_of_shells of its surface; empty if that is no manifold
};

/// Returns the cells that are kept (kept_cells) of a lattice on planes (lattice_planes) turned to a closed
/// surface's directions (lattice_axes), as hexahedra of about `size`.  Their surface is a manifold unless
/// `shells` is empty. Throws Error(kLimit) for more cells than memory holds. The same to the bit for any
/// number of threads; interrupted as watched loops are.
Lattice lattice_of(const Surface& surface, double size, const NarrowFeatures& narrow = {});

/// Returns the cells that are kept of a lattice on planes turned by `axes`, those of lattice_of or others:
/// `planes_of` is given the surface in coordinates along the axes. Otherwise as lattice_of.
Lattice lattice_between(const Surface& surface, const Quaternion& axes,
                        const std::function<LatticePlanes(const Surface& along)>& planes_of);

/// Whether lattice_of has other planes with a level than with `narrow.level`.
bool has_other_planes(const Surface& surface, double size, NarrowFeatures narrow, NarrowLevel level);

/// Returns euler_numbers_of_shells of the quads around hexahedra.
std::vector<int> shells_of(const HexMesh& mesh);

}  // namespace crossgrain
