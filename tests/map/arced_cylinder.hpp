// SPDX-License-Identifier: Apache-2.0
// A cylinder with four arcs along it, ready for a map.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reduction/mapped_shapes.hpp"
#include "repair/repaired_matchings.hpp"

namespace crossgrain::testing {

inline RepairedTets repaired_cylinder(const TetComplex& complex) {
  const auto frames = frames_at_centroids(complex.solid(), [](const Vector3& p) {
    // Straight near the axis, along the radius at the surface: four lines between.
    const double angle = std::atan2(p[1], p[0]), quarter = std::numbers::pi / 2;
    const double nearest = angle - quarter * std::round(angle / quarter);
    return from_rotation_vector({0, 0, std::clamp(2.5 * std::hypot(p[0], p[1]) - 1.2, 0.0, 1.0) * nearest});
  });
  return repaired_tets(MatchedField(complex, frames), {});
}

/// A cylinder of radius 1 and height 2 with repaired matchings, four arcs along it, and tets split for a map.
struct ArcedCylinder {
  TetSolid given = solid_of(tet_cylinder(8));
  TetComplex complex{given};
  RepairedTets repaired = repaired_cylinder(complex);
  OwnedField split = split_for_map(MatchedField(complex, repaired.frames, repaired.matchings));
  CutSolid cut{*split.field};
  MapUnknowns unknowns{cut};

  ArcedCylinder() = default;
  ArcedCylinder(const ArcedCylinder&) = delete;
};

}  // namespace crossgrain::testing
