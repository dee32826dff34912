// SPDX-License-Identifier: Apache-2.0
// The user's constraints as guides, which cells take for further surface.
#pragma once

#include <array>
#include <span>

#include "crossgrain/constraints.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Of a vector that is neither zero nor infinite, however long.
Vector3 unit_vector(const Vector3& vector);

/// The directions of one axis or of a frame (Constraints), as unit vectors; of a frame the nearest three at
/// right angles, in the sense of least squares: M (M^T M)^(-1/2), M the matrix of the unit axes.
std::vector<Vector3> directions_of(std::span<const Vector3> axes);

/// Unit eigenvectors of a tensor xx, yy, zz, yz, xz, xy by ascending eigenvalue, and how much each of them is
/// determined: its gap (Constraints::Stress), from 0 to 1. Gaps below kSmallestGap are 0, since rounding
/// could have made them.
struct StressAxes {
  std::array<Vector3, 3> directions;
  std::array<double, 3> gaps;

  bool say_nothing() const { return gaps == std::array<double, 3>{}; }
};
StressAxes stress_axes(const std::array<double, 6>& tensor);
inline constexpr double kSmallestGap = 1e-6;

/// Adds all constraints but stresses without a gap. They must be checked (check_constraints). Throws
/// Error(kInput) for a face number that no triangle has, naming those that there are.
void add_constraints(const Constraints& constraints, const Surface& surface, Guides& guides);

}  // namespace crossgrain
