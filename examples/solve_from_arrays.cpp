// SPDX-License-Identifier: Apache-2.0
// Solves for a field from arrays in memory and writes it for ParaView.
//
//   example_solve_from_arrays [FOLDER]
//
// Vertices and triangles may come from any source; here they are those of a box. The frames in a box have its
// directions everywhere.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "crossgrain/crossgrain.hpp"
#include "solid_shapes.hpp"

int main(int argc, char** argv) {
  using namespace crossgrain;
  try {
    const TriangleMesh mesh = box({2, 1, 1.5});
    SolveOptions options;
    options.resolution = 32;  // finest cells along the longest side
    const FrameField field = solve(mesh, options);
    if (argc > 1) write_field(field, argv[1]);

    const SolveReport& report = field.report();
    std::printf("%zu cells, energy %.3g, %.3g degrees off the surface in the mean\n", field.size(),
                report.energy.total, report.alignment_deg.mean.value_or(0));
    double least_cosine = 1;
    for (std::size_t i = 0; i < field.size(); ++i) {
      for (const Vector3& axis : field.cell(i).frame.axes) {
        const double along = std::max({std::abs(axis[0]), std::abs(axis[1]), std::abs(axis[2])});
        least_cosine = std::min(least_cosine, along);
      }
    }
    if (least_cosine < 0.9999) return 1;
    std::puts("all frames follow the box");
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
