// SPDX-License-Identifier: Apache-2.0
// Features without some of their curves.
#pragma once

#include <cstdint>
#include <vector>

#include "fit/feature_loops.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// A complex with fewer curves, and where its parts come from.
struct CoarserFeatures {
  FeatureComplex complex;
  std::vector<std::uint32_t> corner_of;               ///< of each corner, the one that it was
  std::vector<std::vector<LoopStep>> parts_of_curve;  ///< curves that it was, from its first end on
  std::vector<std::uint32_t> face_of;                 ///< of each face that was, the one that holds it
};

/// Whether a complex can do without a curve: the same two solids on both sides.
bool is_dispensable(const FeatureComplex& features, std::uint32_t curve);

/// Leaves curves out that are dispensable. Faces beside them become one, with the number of the largest.
/// Corners that lose an end go where no end is left, or where two are left that continue each other: their
/// curves become one. Without curves left out the result is the same complex.
CoarserFeatures without_curves(const FeatureComplex& features, const std::vector<bool>& is_left_out);

}  // namespace crossgrain
