// SPDX-License-Identifier: Apache-2.0
// Arrays in, a field out: on a grid, on tets, streamlines and singularities, with the core library alone.
#include <cstdio>

#include "crossgrain/solve.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/version.hpp"

int main() {
  const crossgrain::TetMesh cube{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
      {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
  crossgrain::SolveOptions options;
  options.resolution = 8;
  const crossgrain::TetFrameField field = crossgrain::solve_onto(crossgrain::TetDomain(cube), options);
  const crossgrain::StreamlineTracer tracer(field.grid());
  const bool is_sound = field.vertex_frames().size() == 8 && field.singularities().arcs.empty() &&
                        !tracer.trace(tracer.spread_seeds(4)).lines.empty();
  std::printf("crossgrain %s\n", crossgrain::kVersion);
  return is_sound ? 0 : 1;
}
