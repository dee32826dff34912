// SPDX-License-Identifier: Apache-2.0
// Measures where singular arcs lie (docs/notes/solver.md). A cylinder of radius 0.55 and height 1.4 has four
// straight arcs, which are alike for any rotation relative to the grid.
//
//   arc_sweep [RELAXED_CELLS...]      default: that of SolverTuning
//
// Prints for every value, rotation and resolution: the range of the mean radii of the four arcs, relative to
// their mean, and the largest distance of a point from its arc's mean line, in cells; both for the parts
// farther than 0.2 from the caps.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "solve/tuned_solve.hpp"
#include "support/cylinder_arcs.hpp"
#include "support/shapes.hpp"

using namespace crossgrain;

int main(int argc, char** argv) {
  std::vector<std::size_t> values;
  for (int k = 1; k < argc; ++k) values.push_back(static_cast<std::size_t>(std::atof(argv[k])));
  if (values.empty()) values.push_back(SolverTuning().relaxed_cells);
  const std::vector<Vector3> turns{
      {0, 0, 0}, {0.21, 0.21, 0}, {0.9, -0.4, 0.3}, {-0.2, 1.1, 0.6}, {0.5, 0.3, -1.3}};
  for (const std::size_t value : values) {
    for (const Vector3& turn : turns) {
      std::printf("relaxed_cells = %-8zu turned by (%4.1f, %4.1f, %4.1f)", value, turn[0], turn[1], turn[2]);
      for (const int resolution : {64, 96, 128, 192, 256}) {
        SolveTuning options;
        options.resolution = resolution;
        options.solver.relaxed_cells = value;
        const Quaternion rotation = from_rotation_vector(turn);
        const FrameField field = solve(rotate_mesh(make_cylinder(0.55, 0.7, 256, 16), rotation), options);
        const CylinderArcs arcs = measure_cylinder_arcs(field.singularities(), rotation, 0.5);
        const double cell = longest_side(field.report().model.bounding_box) / resolution;
        std::printf("  %3d: %4.1f %% %4.1f", resolution, 100 * arcs.spread, arcs.off_straight / cell);
        std::fflush(stdout);
      }
      std::printf("\n");
    }
  }
}
