// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// On grids, largest distance between two ends on the surface from which one line goes on, and how far the
/// other end may lie beside the direction of either: a line that touches the surface between cells has no
/// edges there.
constexpr double kTouchCells = 3, kTouchAsideCells = 1.5;

/// SingularityTuning::hook_cells.
constexpr double kHookReachCells = 1.5;

/// Largest distance by which smoothing moves a point. A straight line is nowhere further than sqrt(1/2)
/// from the nearest staircase of unit cells.
constexpr double kShiftCells = 0.75;

/// Angle within which of 45, 135, 225 or 315 degrees of solid the number of hexahedra at a crease is left
/// to the frames, or undecided.
constexpr double kRoundingDeg = 5;

/// Smallest angle by which the surface turns at a crease, and by which a crease turns at a corner, for
/// these numbers: as on tets (tets/boundary_vertices.hpp).
constexpr double kSharpDeg = 30, kBendDeg = 45;

/// How singular edges become a graph. Lengths are in sizes of the local cells, or in mean edge lengths of the
/// local tets.
struct SingularityTuning {
  /// Largest length of an arc that is merged into its node: where several lines meet within a cell or two,
  /// the singular edges form a few nodes joined by short arcs.
  double merge_cells = 2.5;

  /// On grids, largest length of an arc from a node to the surface that is merged into the node, in place of
  /// `merge_cells`: lines that end side by side on the surface often meet in the cells before.
  double end_cells = 4;

  /// Largest length of an arc from surface to surface that is left out where it stays within
  /// kHookReachCells of one crease. Where the angle of solid at a crease passes 45, 135, 225 or 315
  /// degrees, two numbers of hexahedra cost alike, and the line between them runs along the crease, in and
  /// out of the first cells. docs/notes/verdict.md has the sweep.
  double hook_cells = 12;

  /// How near a crease an arc from surface to surface of at most `merge_cells` is left out too: at a knife
  /// edge the tip has no room for lines across it.
  double tip_reach_cells = 3;

  /// Largest length of a closed arc that is left out: where frames of neighbours differ by more than 45
  /// degrees the matching is ambiguous, and a wrong one produces a loop around its face.
  double loop_cells = 6;

  /// Rounds of averaging over neighbours: enough to straighten steps every ten cells.
  int smoothing_rounds = 100;

  /// The sense of a rotation is noise where its axis is nearly across the arc: an arc changes its sense where
  /// the cosine between them is above `sign_cosine` over a length of `sign_cells`, and below -`sign_cosine`
  /// over as long a part. docs/notes/verdict.md has the sweep.
  double sign_cosine = 0.2;
  double sign_cells = 2;
};

}  // namespace crossgrain
