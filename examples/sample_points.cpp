// SPDX-License-Identifier: Apache-2.0
// Samples the frame at any point.
#include <cstdio>
#include <vector>

#include "crossgrain/crossgrain.hpp"
#include "solid_shapes.hpp"

int main() {
  using namespace crossgrain;
  try {
    SolveOptions options;
    options.resolution = 32;
    const FrameField field = solve(cylinder(0.5, 2), options);
    // Outside the solid the result is that of the nearest cell, and is marked as outside.
    const std::vector<Vector3> points{{0, 0, 1}, {0.45, 0, 1}, {0.3, 0.3, 0.1}, {2, 0, 1}};
    std::size_t outside = 0;
    for (const Vector3& point : points) {
      const FrameField::Sample sample = field.sample(point);
      outside += !sample.in_active_cell;
      std::printf("(%g, %g, %g)%s\n", point[0], point[1], point[2], sample.in_active_cell ? "" : ", outside");
      for (const Vector3& axis : sample.frame.axes)
        std::printf("  % .6f % .6f % .6f\n", axis[0], axis[1], axis[2]);
    }
    std::printf("%zu of %zu points are outside\n", outside, points.size());
    return outside == 1 ? 0 : 1;
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
