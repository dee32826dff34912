// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// Directions to follow besides the surface (docs/constraints.md). Constraints are soft: each adds to the
/// energy like a piece of surface, so that none is met exactly.
///
/// `axes` are directions of any length except zero; their signs do not matter. One direction requests an axis
/// along it, three orthogonal directions request that frame. Three directions that are off a right angle by
/// up to kFrameToleranceDeg are replaced by the nearest orthogonal ones.
///
/// Weights are dimensionless, positive and at most kLargestConstraintWeight. An axis of weight 1 counts in
/// its cell like a piece of surface across the width of the cell with that normal, one of weight 2 twice as
/// much.
struct Constraints {
  struct Point {
    Vector3 at;
    std::vector<Vector3> axes;
    double weight = 1;
    std::size_t line = 0;  ///< line of `source`, for messages; 0 if there is none
  };

  struct Polyline {
    std::vector<Vector3> points;     ///< at least two, not all equal
    std::vector<Vector3> axes = {};  ///< none: the direction of each segment
    double weight = 1;
    std::size_t line = 0;
  };

  /// All triangles with this number (TriangleMesh::faces).
  struct Face {
    std::int32_t face;
    std::vector<Vector3> axes = {};  ///< none: the normal of the face, as for any surface
    double weight = 1;
    std::size_t line = 0;
  };

  /// Axes along the eigenvectors of a symmetric tensor. The weight of an eigenvector is `weight` times the
  /// gap between its eigenvalue and the nearest other one, divided by the length of the shortest interval
  /// that holds all three and 0: a measure of how well it is determined. An isotropic tensor has no effect,
  /// one with two equal eigenvalues determines one axis. Units and scale do not matter.
  struct Stress {
    Vector3 at;
    std::array<double, 6> tensor;  ///< xx, yy, zz, yz, xz, xy
    double weight = 1;
    std::size_t line = 0;
  };

  std::vector<Point> points = {};
  std::vector<Polyline> polylines = {};
  std::vector<Face> faces = {};
  std::vector<Stress> stresses = {};

  std::string source = {};  ///< file of the constraints, for messages; empty if there is none

  bool empty() const { return points.empty() && polylines.empty() && faces.empty() && stresses.empty(); }
};

/// Largest deviation from a right angle, in degrees, between two axes of a frame. Coordinates rounded to two
/// digits are up to half a degree off.
inline constexpr double kFrameToleranceDeg = 1;

/// Up to this weight the rounding of forms in single precision stays far below the weights of smoothness.
inline constexpr double kLargestConstraintWeight = 1e4;

/// Throws Error(kInput) for the first constraint that is invalid by itself: numbers that are not finite,
/// weights out of range, directions of length zero, axes that are neither one nor three at right angles,
/// polylines without length. Only a solve checks whether the model has the faces.
void check_constraints(const Constraints& constraints);

/// @}

}  // namespace crossgrain
