// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "crossgrain/singularity_graph.hpp"

namespace crossgrain {

/// How the arcs of a cylinder lie, of which it has four, straight and alike.
struct CylinderArcs {
  double spread = 0;        ///< largest less smallest mean distance from the cylinder's axis, over their mean
  double off_straight = 0;  ///< largest distance of a point from its arc's mean line, model units
};

/// Of a cylinder about the z axis, turned by `turn`: of the points less than `half_height` from its middle.
inline CylinderArcs measure_cylinder_arcs(const SingularityGraph& graph, const Quaternion& turn,
                                          double half_height) {
  CylinderArcs result;
  std::vector<double> radii;
  for (const SingularityGraph::Arc& arc : graph.arcs) {
    std::vector<Vector3> points;
    Vector3 mean{};
    for (const Vector3& point : arc.points) {
      const Vector3 upright = rotate(conjugate(turn), point);
      if (std::abs(upright[2]) > half_height) continue;
      points.push_back({upright[0], upright[1], 0});
      mean += points.back();
    }
    if (points.empty()) continue;
    mean = 1.0 / static_cast<double>(points.size()) * mean;
    radii.push_back(norm(mean));
    for (const Vector3& point : points)
      result.off_straight = std::max(result.off_straight, norm(point - mean));
  }
  if (radii.empty()) return result;
  const auto [least, most] = std::minmax_element(radii.begin(), radii.end());
  double sum = 0;
  for (const double radius : radii) sum += radius;
  result.spread = (*most - *least) * static_cast<double>(radii.size()) / sum;
  return result;
}

}  // namespace crossgrain
