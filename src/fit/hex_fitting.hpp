// SPDX-License-Identifier: Apache-2.0
// Hexahedra moved onto what their vertices belong to, from valid to valid.
#pragma once

#include <cstddef>

#include "crossgrain/hex_mesh.hpp"
#include "fit/hex_carriers.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

struct HexFittingOptions {
  int point_rounds = 3;  ///< with vertices pulled to places spread evenly over their carriers
  int slide_rounds = 3;  ///< with vertices pulled to the nearest places of them
  int steps = 25;        ///< of descent in a round

  int relaxations = 12;  ///< sweeps over single vertices, between which they are put onto their carriers
  int lifts = 20;        ///< sweeps over the vertices of the worst hexahedra

  /// The least scaled Jacobian for which a vertex goes all the way to its carrier: kPoorestShape. With 0.05,
  /// two corners at which a cylinder and a plane meet at no angle are not reached.
  double floor = 0.02;

  /// Hexahedra below this scaled Jacobian are lifted.
  double lifted_below = 0.4;

  int raises = 30;  ///< sweeps over the vertices of the worst hexahedra once all are where they stay, at most

  /// Hexahedra below this scaled Jacobian are raised: kGoodShape. With 0.3 and 0.4 the worst of nine models
  /// with poor ones are as good within 0.005.
  double raised_below = 0.2;
};

struct HexFittingResult {
  std::size_t invalid = 0;  ///< hexahedra that no round could untangle
  std::size_t off = 0;      ///< vertices that are not on their carrier
};

/// Moves the vertices of a mesh to the corners, curves and faces that carry them, and those inside so that
/// hexahedra are near to cubes; `size` is their edge. What lies between vertices is followed too
/// (`quad_pulls`). Never makes a valid mesh invalid: the energy of shapes is a barrier, and each accepted
/// state is valid by `is_valid`. One with invalid hexahedra is untangled first.
///
/// Vertices stay off their carrier where the hexahedra around would become worse than the options allow.
/// Where hexahedra are further inside than a few layers, they stay as they are (near_surface).
///
/// The same to the bit for any number of threads. Interrupted as watched loops are; the mesh then is an
/// accepted state, or as given.
HexFittingResult fit_onto(HexMesh& mesh, const FeatureComplex& complex, const HexCarriers& carriers,
                          double size, const HexFittingOptions& options = {});

}  // namespace crossgrain
