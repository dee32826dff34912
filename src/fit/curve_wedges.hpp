// SPDX-License-Identifier: Apache-2.0
// The angles between the faces of a model along its curves.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/feature_complex.hpp"

namespace crossgrain {

/// What a solid fills between two faces that follow each other around a curve.
struct CurveWedge {
  std::uint32_t from, to;  ///< indices of Curve::sides, counter-clockwise around the curve's direction
  std::int32_t solid;
  double mean_rad, most_rad;  ///< along the curve, weighted by length; its largest
};

/// Returns the wedges of each curve, those of its triangles; none outside the solids, nor at open edges.
std::vector<std::vector<CurveWedge>> wedges_of_curves(const FeatureComplex& features);

}  // namespace crossgrain
