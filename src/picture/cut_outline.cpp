// SPDX-License-Identifier: Apache-2.0
#include "picture/cut_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossgrain {

CutOutline::CutOutline(const std::vector<Vector3>& vertices,
                       const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t axis,
                       double position)
    : axis_(axis) {
  for (const auto& corners : triangles) {
    std::array<Vector3, 2> ends;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 &a = vertices[corners[i]], &b = vertices[corners[(i + 1) % 3]];
      const double to_a = a[axis] - position, to_b = b[axis] - position;
      if ((to_a > 0) == (to_b > 0)) continue;
      Vector3 end = a + to_a / (to_a - to_b) * (b - a);
      end[axis] = position;
      if (count < 2) ends[static_cast<std::size_t>(count++)] = end;
    }
    if (count < 2) continue;
    const Vector3& a = vertices[corners[0]];
    segments_.push_back({ends[0], ends[1], cross(vertices[corners[1]] - a, vertices[corners[2]] - a)});
  }
}

bool CutOutline::encloses(const Vector3& point) const {
  const std::size_t along = (axis_ + 1) % 3, across = (axis_ + 2) % 3;
  int winding = 0;
  for (const Segment& segment : segments_) {
    const double from = segment.from[across] - point[across], to = segment.to[across] - point[across];
    if ((from > 0) == (to > 0)) continue;
    const double meets = segment.from[along] + from / (from - to) * (segment.to[along] - segment.from[along]);
    if (meets > point[along]) winding += segment.normal[along] > 0 ? 1 : -1;
  }
  return winding > 0;
}

double CutOutline::distance_to(const Vector3& point) const {
  double least2 = std::numeric_limits<double>::infinity();
  for (const Segment& segment : segments_) {
    const Vector3 along = segment.to - segment.from, off = point - segment.from;
    const double length2 = dot(along, along);
    const double share = length2 > 0 ? std::clamp(dot(off, along) / length2, 0.0, 1.0) : 0;
    const Vector3 rest = off - share * along;
    least2 = std::min(least2, dot(rest, rest));
  }
  return std::sqrt(least2);
}

}  // namespace crossgrain
