// SPDX-License-Identifier: Apache-2.0
// Converts the user's constraints to guides, which cells treat like additional surface.
#pragma once

#include <array>
#include <span>

#include "crossgrain/constraints.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the unit vector of a vector of any length except zero and infinity.
Vector3 unit_vector(const Vector3& vector);

/// Returns the directions of one axis or of a frame (Constraints) as unit vectors. A frame becomes the
/// nearest three orthogonal vectors in the sense of least squares: M (M^T M)^(-1/2), M the matrix of the unit
/// axes.
std::vector<Vector3> directions_of(std::span<const Vector3> axes);

/// Unit eigenvectors of a tensor xx, yy, zz, yz, xz, xy by ascending eigenvalue, and for each its gap
/// (Constraints::Stress), from 0 to 1, which tells how well it is determined. Gaps below kSmallestGap are set
/// to 0, since rounding may have caused them.
struct StressAxes {
  std::array<Vector3, 3> directions;
  std::array<double, 3> gaps;

  bool say_nothing() const { return gaps == std::array<double, 3>{}; }
};
StressAxes stress_axes(const std::array<double, 6>& tensor);
inline constexpr double kSmallestGap = 1e-6;

/// Adds all constraints except stresses without a gap. Precondition: check_constraints passed. Throws
/// Error(kInput) that lists the existing face numbers if no triangle has a given one.
void add_constraints(const Constraints& constraints, const Surface& surface, Guides& guides);

}  // namespace crossgrain
