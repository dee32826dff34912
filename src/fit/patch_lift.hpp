// SPDX-License-Identifier: Apache-2.0
// Moves of all vertices around poor hexahedra at once.
#pragma once

#include <cstddef>

#include "crossgrain/hex_mesh.hpp"
#include "fit/hex_carriers.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Returns how many patches of valid hexahedra were moved so that the worst in them rise: those around
/// hexahedra with a scaled Jacobian below kGoodShape, the worst first. `size` is the edge of hexahedra.
///
/// A patch is all hexahedra within two layers of a poor one. The vertices that no others share move at once
/// to less `poorness`, with powers that rise, so that at last the worst count alone. Unlike the energy that
/// takes vertices to their carriers, it has no term for volumes and places. Vertices on a carrier slide along
/// it; those that are off theirs move too, without going farther from it. Between rounds they are put onto it
/// where there is room now.
///
/// What lies between vertices may come to be further off the model: the caller judges that. The same to the
/// bit for any number of threads; interrupted as watched loops are, with a valid mesh.
std::size_t lift_patches(HexMesh& mesh, const FeatureComplex& complex, const HexCarriers& carriers,
                         double size);

}  // namespace crossgrain
