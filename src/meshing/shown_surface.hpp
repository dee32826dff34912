// SPDX-License-Identifier: Apache-2.0
// The surface of a model that hexahedra are put onto, for display.
#pragma once

#include <memory>

#include "field/solved_surface.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Returns the triangles of a model, as one solid, with the numbers of its faces and, as creases, the curves
/// across which it is not smooth.
std::shared_ptr<const SolvedSurface> shown_surface(const FeatureComplex& features);

}  // namespace crossgrain
