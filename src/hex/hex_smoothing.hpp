// SPDX-License-Identifier: Apache-2.0
// Better shapes of hexahedra.
#pragma once

#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "hex/surface_feet.hpp"
#include "map/descent.hpp"

namespace crossgrain {

struct HexSmoothingOptions {
  double volume_weight = 0.05;  ///< of the change of volume against that of shape
  double largest_epsilon = 0.1;

  /// Powers of the energy of a corner, one stage after the other: with higher ones the worst shapes count
  /// more.
  std::vector<double> powers = {1, 4, 16};

  int rounds = 40;           ///< of a stage, each with a projection to the surface
  int rounds_in_vain = 6;    ///< the end of a stage if the shapes do not get better in so many
  double least_gain = 1e-3;  ///< of the score below which a round is in vain

  /// The score is the least scaled Jacobian, as far as it is below `good_enough`, and the mean times a
  /// weight.
  double good_enough = 0.5;
  double mean_weight = 0.5;

  /// How far vertices of hexahedra that stay inverted or flat may leave the surface, in sizes of hexahedra:
  /// where a map bends on a smooth face, nothing else gives them a volume.
  double slack = 0.04;

  DescentOptions descent{.steps = 20};
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
