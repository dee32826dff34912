// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// SingularityTuning::merge_cells.
constexpr double kMergeCells = 2.5;

/// How singular edges become a graph. Lengths are in sizes of the local cells, or in mean edge lengths of the
/// local tets.
struct SingularityTuning {
  /// Largest length of an arc that is merged into its node: where several lines meet within a cell or two,
  /// the singular edges form a few nodes joined by short arcs. 0: nothing is merged or left out, if
  /// `end_cells` is 0 too.
  double merge_cells = kMergeCells;

  /// On grids, largest length of an arc from a node to the surface that is merged into the node, in place of
  /// `merge_cells`: lines that end side by side on the surface often meet in the cells before.
  double end_cells = 4;

  /// Rounds of averaging over neighbours: enough to straighten steps every ten cells.
  int smoothing_rounds = 100;

  /// The sense of a rotation is noise where its axis is nearly across the arc: an arc changes its sense where
  /// the cosine between them is above `sign_cosine` over a length of `sign_cells`, and below -`sign_cosine`
  /// over as long a part. docs/notes/verdict.md has the sweep.
  double sign_cosine = 0.2;
  double sign_cells = 2;
};

}  // namespace crossgrain
