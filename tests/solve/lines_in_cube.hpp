// SPDX-License-Identifier: Apache-2.0
// What tests of streamlines on grids and on tets share: fields in the unit cube.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/streamlines.hpp"
#include "sampling/streamline_tuning.hpp"

namespace crossgrain::testing {

/// A frame with another of the 24 names for its axes.
inline Quaternion renamed(Quaternion frame, std::mt19937& engine) {
  for (auto turns = engine() % 5; turns > 0; --turns) {
    Vector3 turn{0, 0, 0};
    turn[engine() % 3] = std::numbers::pi / 2;
    frame = frame * from_rotation_vector(turn);
  }
  return frame;
}

/// 0 on the faces of the unit cube.
inline double distance_to_faces(const Vector3& p) {
  double least = INFINITY;
  for (const double x : p) least = std::min({least, std::abs(x), std::abs(1 - x)});
  return least;
}

/// Expects lines to end on the cube or at StreamlineTuning::arc_distance_cells from singular edges, and to
/// come no nearer.
template <class CellsToEdges>
void expect_ends_on_the_cube_or_at_edges(const std::vector<Streamline>& lines,
                                         const CellsToEdges& cells_to_edges) {
  const double least = StreamlineTuning{}.arc_distance_cells;
  std::size_t at_arc = 0, at_boundary = 0;
  for (const Streamline& line : lines) {
    for (const Vector3& p : line.points) ASSERT_GT(cells_to_edges(p), least - 1e-6);
    for (const auto& [end, p] :
         {std::pair{line.first_end, line.points.front()}, std::pair{line.last_end, line.points.back()}}) {
      if (end == StreamlineEnd::kSingularArc) {
        ++at_arc;
        // The straight way that is stopped there may be off by the tolerance of ends.
        EXPECT_NEAR(cells_to_edges(p), least, 1e-3);
      } else {
        ASSERT_EQ(end, StreamlineEnd::kBoundary);
        ++at_boundary;
        EXPECT_LT(distance_to_faces(p), 1e-12);
      }
    }
  }
  EXPECT_GT(at_arc, 10u);
  EXPECT_GT(at_boundary, at_arc);
}

}  // namespace crossgrain::testing
