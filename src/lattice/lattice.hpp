// SPDX-License-Identifier: Apache-2.0
// Hexahedra of a lattice that roughly fill a model.
#pragma once

#include <cstddef>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/types.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Holes, slots and bosses narrower than two sizes, which get planes of their own.
struct NarrowFeatures {
  std::vector<std::vector<Vector3>>
      points;               ///< of each, from which its box along the lattice's axes is found
  bool have_rings = false;  ///< planes around them too: for thin walls beside holes
};

struct Lattice {
  HexMesh mesh;             ///< with its boundary, without tags
  Quaternion axes;          ///< lattice_axes
  std::size_t toggled = 0;  ///< KeptCells
  std::vector<int> shells;  ///< euler_numbers_of_shells of its surface; empty if that is no manifold
};

/// Returns the cells that are kept (kept_cells) of a lattice on planes (lattice_planes) turned to a closed
/// surface's directions (lattice_axes), as hexahedra of about `size`.  Their surface is a manifold unless
/// `shells` is empty. Throws Error(kLimit) for more cells than memory holds. The same to the bit for any
/// number of threads; interrupted as watched loops are.
Lattice lattice_of(const Surface& surface, double size, const NarrowFeatures& narrow = {});

/// Returns euler_numbers_of_shells of the quads around hexahedra.
std::vector<int> shells_of(const HexMesh& mesh);

}  // namespace crossgrain
