// SPDX-License-Identifier: Apache-2.0
// Better shapes of hexahedra.
#pragma once

#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "hex/surface_feet.hpp"

namespace crossgrain {

struct HexSmoothingOptions {
  /// Powers of the energy of a corner, one stage after the other: with higher ones the worst shapes count
  /// more.
  std::vector<int> powers = {1, 4, 16};

  int rounds = 40;  ///< of a stage, each with a projection to the surface

  /// How far vertices of hexahedra that stay inverted or flat may leave the surface, in sizes of hexahedra:
  /// where a map bends on a smooth face, nothing else gives them a volume.
  double slack = 0.04;
};

/// Moves vertices so that no hexahedron is inverted and each is near to a cube, where it can: those inside
/// anywhere, those of the surface along what they keep to (Foot). Returns the best of the rounds: the one
/// with the fewest inverted hexahedra, then of the highest score. `size` is
/// the edge of hexahedra, in model units; one foot for each vertex.
///
/// The energy is the one of `untangled`, of the tets at the corners of hexahedra. The same to the bit for any
/// number of threads. Interrupted as its watched loops say.
HexMesh smoothed(HexMesh mesh, const MapSurface& surface, const std::vector<Foot>& feet, double size,
                 const HexSmoothingOptions& options = {});

}  // namespace crossgrain
