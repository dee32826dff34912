// SPDX-License-Identifier: Apache-2.0
// The singular lines of a field as they are drawn: with straight ends at the surface, the walls that they run
// in, and marks where they end, meet and turn.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/verdict.hpp"
#include "display/shown_field.hpp"

namespace crossgrain {

/// How an arc is coloured: by its index, unless it is impossible or undecided.
enum class LineKind : std::uint8_t { kThree, kFive, kSix, kImpossible, kUndecided };
LineKind kind_of(const SingularityGraph::Arc& arc);

/// A wall that limits nothing, as at open surfaces.
inline constexpr double kNoWall = std::numeric_limits<double>::infinity();

/// Largest radius of a line as a share of the wall around it: it takes a third of the wall, so that the space
/// on both sides of it, and which of the two is the smaller, can be seen.
inline constexpr double kLineShareOfWall = 1.0 / 6;

/// Returns the radius of a line: the usual one, or less in a thin wall.
inline double line_radius(double usual, double wall) {
  return wall * kLineShareOfWall < usual ? wall * kLineShareOfWall : usual;
}

struct DrawnLine {
  LineKind kind = LineKind::kThree;
  std::vector<Vector3> points;  ///< model units; a closed line ends with its first point

  /// At each point the length of the shortest chord through the solid, across the line or along it, model
  /// units, or kNoWall. Along the line it changes by at most half of the way.
  std::vector<double> walls;

  double length = 0;  ///< model units
};

enum class MarkShape : std::uint8_t {
  kNode,          ///< several arcs meet
  kEnd,           ///< on the surface
  kTurningPoint,  ///< an impossible line changes its sense
};

struct LineMark {
  MarkShape shape{};
  Vector3 place{};

  /// Unit: the outward normal of the surface for kEnd, the direction of the line for kTurningPoint; zero for
  /// kNode.
  Vector3 direction{};

  double wall = kNoWall;                 ///< as DrawnLine::walls
  double length = kNoWall;               ///< of the shortest line there, model units
  Verdict verdict = Verdict::kMeshable;  ///< of the node; kMeshable for turning points
  LineKind kind = LineKind::kThree;      ///< of the first line there
};

struct DrawnLines {
  std::vector<DrawnLine> lines;  ///< one for each arc, in their order
  std::vector<LineMark> marks;   ///< an end on the surface where arcs meet is a node too
};

/// Returns the lines of a field as they are drawn. The same for any number of threads.
DrawnLines drawn_lines(const ShownField& field);

}  // namespace crossgrain
