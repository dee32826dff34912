// SPDX-License-Identifier: Apache-2.0
// Adds a constraint to those of the surface: an axis along a diagonal in the middle of a box.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "crossgrain/crossgrain.hpp"
#include "solid_shapes.hpp"

int main() {
  using namespace crossgrain;
  try {
    const Vector3 middle{1, 1, 0.5}, diagonal{std::sqrt(0.5), std::sqrt(0.5), 0};
    SolveOptions options;
    options.resolution = 32;
    // With weight 1 an axis counts as much in its cell as a surface across it with the cell's width.
    options.constraints.points.push_back({middle, {diagonal}, 10});
    const FrameField field = solve(box({2, 2, 1}), options);

    const auto cosine_at = [&](const Vector3& point) {
      double largest = 0;
      for (const Vector3& axis : field.sample(point).frame.axes)
        largest = std::max(largest, std::abs(axis[0] * diagonal[0] + axis[1] * diagonal[1]));
      return largest;
    };
    constexpr double kRadian_deg = 57.29577951308232;
    const double there = kRadian_deg * std::acos(std::min(1.0, cosine_at(middle)));
    const double at_wall = kRadian_deg * std::acos(std::min(1.0, cosine_at({0.05, 1, 0.5})));
    std::printf("%.2f degrees off the diagonal in the middle, %.2f beside a wall\n", there, at_wall);
    if (!(there < 2 && at_wall > 30)) return 1;
    std::puts("the frame in the middle is turned to the diagonal");
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
