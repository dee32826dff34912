// SPDX-License-Identifier: Apache-2.0
// Holes, slots and bosses of a model, and the borders of its fillets.
#pragma once

#include <vector>

#include "crossgrain/types.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

struct Hole {
  std::vector<Vector3> points;
  bool is_boss = false;  ///< its wall looks outward
};

/// Returns each hole, slot and boss with a smooth wall: faces, together with those across soft curves, whose
/// normals look to all sides alike.
std::vector<Hole> holes_of(const FeatureComplex& features);

/// Returns the points of each soft curve, such as the border of a fillet.
std::vector<std::vector<Vector3>> soft_lines_of(const FeatureComplex& features);

}  // namespace crossgrain
