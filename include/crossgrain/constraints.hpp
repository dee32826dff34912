// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// What frames are to follow besides the surface (docs/constraints.md). None of it is met exactly: each adds
/// to the energy as surface does, and takes part in the compromise.
///
/// `axes`, wherever there are such, are directions of any length but zero whose signs mean nothing: one, and
/// frames are to have an axis along it; three at right angles, and frames are to be that frame. Three that
/// are off the right angle by up to kFrameToleranceDeg count as the nearest ones that are not.
///
/// Weights are dimensionless, positive and at most kLargestConstraintWeight: with 1 an axis counts as much in
/// its cell as surface across it that fills the cell's width, with 2 as twice so much.
struct Constraints {
  struct Point {
    Vector3 at;
    std::vector<Vector3> axes;
    double weight = 1;
    std::size_t line = 0;  ///< of `source`, for messages; 0 where there is none
  };

  struct Polyline {
    std::vector<Vector3> points;     ///< two at least, not all equal
    std::vector<Vector3> axes = {};  ///< none: along each of its straight pieces
    double weight = 1;
    std::size_t line = 0;
  };

  /// All triangles with this number (TriangleMesh::faces).
  struct Face {
    std::int32_t face;
    std::vector<Vector3> axes = {};  ///< none: across the face, as the surface itself asks
    double weight = 1;
    std::size_t line = 0;
  };

  /// Frames are to have axes along the eigenvectors of a symmetric tensor. Each eigenvector has as its weight
  /// the gap between its eigenvalue and the nearest other one, over the length of the shortest interval that
  /// holds all three and 0, times `weight`: so much is it determined. An isotropic tensor says nothing, one
  /// with two equal eigenvalues fixes one axis. Units and scale mean nothing.
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

  std::string source = {};  ///< the file that they come from, for messages; empty for none

  bool empty() const { return points.empty() && polylines.empty() && faces.empty() && stresses.empty(); }
};

/// Degrees that any two of the three axes of a frame may be off the right angle: coordinates rounded to two
/// digits are up to half a degree off.
inline constexpr double kFrameToleranceDeg = 1;

/// Up to this weight rounding of forms in single precision stays far below the weights of smoothness.
inline constexpr double kLargestConstraintWeight = 1e4;

/// Throws Error(kInput) for the first constraint that makes no sense by itself: numbers that are not finite,
/// weights out of range, directions of length zero, axes that are neither one nor three at right angles,
/// polylines without length. Whether the model has the faces, only a solve knows.
void check_constraints(const Constraints& constraints);

}  // namespace crossgrain
