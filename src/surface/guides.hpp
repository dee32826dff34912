// SPDX-License-Identifier: Apache-2.0
// What frames are to follow besides the surface itself: directions along curves, at points and on faces.
#pragma once

#include <array>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// A straight piece of a curve, or a point where both ends are equal, at which frames are to have an axis
/// along a direction.
struct GuideSegment {
  std::array<Vector3, 2> ends;

  /// At the ends, unit vectors; between them the direction goes evenly from one to the other. Their signs
  /// mean nothing.
  std::array<Vector3, 2> directions;

  /// A piece in a cell counts like so many times its length times the size of the cell of surface, a point
  /// like a piece as long as the cell.
  double weight = 1;
};

/// A triangle on which frames are to have an axis along a direction: across it, for a face inside the solid.
struct GuideFace {
  std::array<Vector3, 3> corners;

  /// At the corners, unit vectors; between them blended. Their signs mean nothing.
  std::array<Vector3, 3> directions;

  /// A piece in a cell counts like so many times its area of surface.
  double weight = 1;
};

/// A point at which frames are to have axes along up to three directions.
struct GuidePoint {
  Vector3 place;
  std::array<Vector3, 3> directions;  ///< unit vectors where their weight is positive; signs mean nothing

  /// In the cell that holds the point a direction counts like so many times the squared size of the cell of
  /// surface, in those around as `reach_cells` says. All points in a cell together count as much as the
  /// weightiest of them would alone, each in proportion to its own weight, so that neither what is sampled
  /// densely nor coarse cells drown the surface.
  std::array<double, 3> weights{};

  /// Along each axis the weight falls from 1 where a centre is up to so many cells less one away to 0 where
  /// it is so many. 1: the cells between whose centres frames are interpolated at the point. 2: the next ones
  /// too, so that the field is flat around the point and interpolation does not shoot beyond it.
  int reach_cells = 1;
};

/// Plain data that nothing changes once it is made.
struct Guides {
  /// Of the surface's own creases. In the cells of `corners`, where creases meet, they do not count: the
  /// faces around say what there is to say, and tangents would contradict each other.
  std::vector<GuideSegment> creases = {};
  std::vector<Vector3> corners = {};

  /// These count everywhere.
  std::vector<GuideSegment> segments = {};
  std::vector<GuideFace> faces = {};
  std::vector<GuidePoint> points = {};

  bool empty() const { return creases.empty() && segments.empty() && faces.empty() && points.empty(); }
};

}  // namespace crossgrain
