// SPDX-License-Identifier: Apache-2.0
// Directions that frames should follow in addition to the surface: along curves, at points and on faces.
#pragma once

#include <array>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// A straight piece of a curve along which frames should have an axis in a given direction. If both ends are
/// equal, it is a point.
struct GuideSegment {
  std::array<Vector3, 2> ends;

  /// Unit vectors at the ends, interpolated linearly between them. Signs have no meaning.
  std::array<Vector3, 2> directions;

  /// Within a cell, a piece counts like surface of area weight * length * cell size; a point counts like a
  /// piece as long as the cell.
  double weight = 1;
};

/// A triangle on which frames should have an axis in a given direction: the normal, for a face inside the
/// solid.
struct GuideFace {
  std::array<Vector3, 3> corners;

  /// Unit vectors at the corners, interpolated between them. Signs have no meaning.
  std::array<Vector3, 3> directions;

  /// Within a cell, a piece counts like surface of weight times its area.
  double weight = 1;
};

/// A point where frames should have axes along up to three directions.
struct GuidePoint {
  Vector3 place;
  std::array<Vector3, 3> directions;  ///< unit vectors where the weight is positive; signs have no meaning

  /// In the cell with the point, a direction counts like surface of area weight * (cell size)^2; in cells
  /// around it, according to `reach_cells`. All points in a cell together count as much as the one of largest
  /// weight would alone, each in proportion to its weight, so that neither dense samples nor coarse cells
  /// outweigh the surface.
  std::array<double, 3> weights{};

  /// Along each axis the weight is 1 up to reach_cells - 1 cells from a cell's centre and falls to 0 at
  /// reach_cells. 1: the cells between whose centres frames are interpolated at the point. 2: also the next
  /// ones, so that the field is flat around the point and interpolation does not overshoot.
  int reach_cells = 1;
};

/// Immutable after construction.
struct Guides {
  /// Creases of the surface itself. They are ignored in cells of `corners`, where creases meet: their
  /// tangents would contradict each other, and the faces around determine the frame.
  std::vector<GuideSegment> creases = {};
  std::vector<Vector3> corners = {};

  /// Applied everywhere.
  std::vector<GuideSegment> segments = {};
  std::vector<GuideFace> faces = {};
  std::vector<GuidePoint> points = {};

  bool empty() const { return creases.empty() && segments.empty() && faces.empty() && points.empty(); }
};

}  // namespace crossgrain
