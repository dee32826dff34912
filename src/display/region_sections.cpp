// SPDX-License-Identifier: Apache-2.0
#include "display/region_sections.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Number of strips of the plane: few edges in each, and little memory.
constexpr std::size_t kStrips = 1024;

using Triangle = std::array<std::uint32_t, 3>;

}  // namespace

RegionSections::RegionSections(const SolvedSurface& surface, const std::vector<std::int32_t>& regions,
                               std::size_t axis, double position)
    : along_((axis + 1) % 3), across_((axis + 2) % 3) {
  std::map<std::int32_t, std::vector<Edge>> edges;
  double low = INFINITY, high = -INFINITY;
  const auto add = [&](const Triangle& corners, std::int32_t region, int side) {
    std::array<Vector3, 2> ends;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      // The end of an edge is the same from both of its triangles, so that outlines close.
      const auto [first, second] = std::minmax(corners[i], corners[(i + 1) % 3]);
      const Vector3 &a = surface.vertices[first], &b = surface.vertices[second];
      const double to_a = a[axis] - position, to_b = b[axis] - position;
      if ((to_a > 0) == (to_b > 0)) continue;
      if (count < 2) ends[count++] = a + to_a / (to_a - to_b) * (b - a);
    }
    if (count < 2) return;
    const Vector3& a = surface.vertices[corners[0]];
    const Vector3 normal = cross(surface.vertices[corners[1]] - a, surface.vertices[corners[2]] - a);
    const int turn = normal[along_] > 0 ? side : -side;
    edges[region].push_back({ends[0][along_], ends[0][across_], ends[1][along_], ends[1][across_], turn});
    for (const Vector3& end : ends) low = std::min(low, end[across_]), high = std::max(high, end[across_]);
  };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    add(surface.triangles[t], surface.regions.empty() ? 0 : surface.regions[t], 1);
  for (std::size_t t = 0; t < surface.interfaces.size(); ++t) {
    add(surface.interfaces[t], surface.interface_regions[t][0], 1);
    add(surface.interfaces[t], surface.interface_regions[t][1], -1);
  }
  if (!(low < high)) return;
  low_ = low;
  strips_per_length_ = kStrips / (high - low);
  for (const std::int32_t region : regions) {
    const auto for_strips = [&](const auto& add_to) {
      for (const Edge& edge : edges[region]) {
        const std::size_t last = strip_of(std::max(edge.from_across, edge.to_across));
        for (std::size_t strip = strip_of(std::min(edge.from_across, edge.to_across)); strip <= last; ++strip)
          add_to(strip, edge);
      }
    };
    outlines_.push_back({region, {kStrips, for_strips}});
  }
}

std::size_t RegionSections::strip_of(double across) const {
  const double strip = (across - low_) * strips_per_length_;
  return static_cast<std::size_t>(std::clamp(strip, 0.0, static_cast<double>(kStrips - 1)));
}

std::optional<std::int32_t> RegionSections::at(const Vector3& point) const {
  if (outlines_.empty()) return std::nullopt;
  const std::size_t strip = strip_of(point[across_]);
  for (const Outline& outline : outlines_) {
    int winding = 0, whole = 0;
    for (const Edge& edge : outline.edges[strip]) {
      const double from = edge.from_across - point[across_], to = edge.to_across - point[across_];
      if ((from > 0) == (to > 0)) continue;
      const double meets = edge.from_along + from / (from - to) * (edge.to_along - edge.from_along);
      if (meets > point[along_]) winding += edge.turn;
      whole += edge.turn;
    }
    if (whole != 0) return std::nullopt;  // an outline that is not closed
    if (winding > 0) return outline.region;
  }
  return std::nullopt;
}

}  // namespace crossgrain
