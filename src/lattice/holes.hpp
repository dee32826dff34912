// SPDX-License-Identifier: Apache-2.0
// Holes, slots and bosses of a model, and the borders of its fillets.
#pragma once

#include <vector>

#include "crossgrain/types.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// Returns the points of each hole, slot and boss with a smooth wall: of faces, together with those across
/// soft curves, whose normals look to all sides alike.
std::vector<std::vector<Vector3>> holes_of(const FeatureComplex& features);

/// Returns the points of each soft curve, such as the border of a fillet.
std::vector<std::vector<Vector3>> soft_lines_of(const FeatureComplex& features);

}  // namespace crossgrain
