// SPDX-License-Identifier: Apache-2.0
// Which features of a model hexahedra of a size can show.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"
#include "measure/measured_curve.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// A curve is shorter than the hexahedra if it has less than this many of their edges; around a hole of one
/// hexahedron's width there are three.
inline constexpr double kLeastLength = 2, kLeastLengthAround = 3;

/// Curves that meet in a corner at 30 degrees are one hexahedron apart at this distance from it.
inline constexpr double kCornerReach = 2;

/// Whether hexahedra of a size can show a feature, and if not, the size of those that could.
struct Resolution {
  bool is_resolved = true;
  double size_to_show = 0;  ///< 0 if resolved
  Vector3 place{0, 0, 0};   ///< of a corner; where a curve is crowded most, otherwise its middle; on a face
};

/// By index in the complex.
struct FeatureResolution {
  std::vector<Resolution> corners, curves, faces;
};

/// Returns what hexahedra of this size resolve.
///
/// A curve: it is not shorter than kLeastLength (a closed one kLeastLengthAround) sizes, and on no stretch of
/// a size or more, nor on half its length, within a size of another curve or another stretch of itself. Where
/// two curves end in the same corner, and within kCornerReach sizes of it along them, they are not crowded;
/// neither are stretches of one curve that lie less than three halves of their distance along it apart.
/// Soft curves crowd none.
///
/// A corner: no other corner, and no curve that does not end in it, is within one size. Those of soft curves
/// alone crowd none.
///
/// A face: some point of it is half a size or more from all its curves, and its longest extent is
/// kLeastLength sizes or more.
FeatureResolution feature_resolution(const FeatureComplex& complex, const std::vector<MeasuredCurve>& lines,
                                     double size);

}  // namespace crossgrain
