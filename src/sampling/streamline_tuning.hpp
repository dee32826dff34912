// SPDX-License-Identifier: Apache-2.0
// How streamlines are traced; docs/notes/streamlines.md has the sweeps. Set by the page, tests and bench
// only.
#pragma once

#include <cstddef>

namespace crossgrain {

/// Lengths in cells are multiples of the side of the cell that holds the point; on tets, of the mean edge
/// length of the tet.
struct StreamlineTuning {
  /// Integration error per length. With 1e-3 a line of a hundred cells is off by at most a tenth of a cell
  /// where neighbouring lines are parallel to it.
  double tolerance = 1e-3;

  /// Largest step, and so the largest distance between points. With one cell, the straight segments are
  /// within 1/40 of a cell of the cubics through points and tangents where frames rotate by 0.2 rad per cell.
  double largest_step_cells = 1;

  /// Smallest step, taken whatever the error: the interpolated field bends sharply only next to singular
  /// arcs, over a part of a cell.
  double smallest_step_cells = 1.0 / 64;

  /// Distance from singular edges at which lines end. Closer to them the interpolated frames are not those of
  /// a smooth field, and the edges locate the arc to half a cell only.
  double arc_distance_cells = 0.5;

  /// A line is closed if it returns to within this distance of its seed in its initial direction.
  double closing_cells = 0.05;

  /// Largest length of a line in each direction from its seed, in longest sides of the field's bounding box.
  double longest_sides = 4;

  /// Largest number of points in each direction.
  std::size_t most_points = 100000;
};

}  // namespace crossgrain
