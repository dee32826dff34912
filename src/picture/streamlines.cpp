// SPDX-License-Identifier: Apache-2.0
#include "picture/streamlines.hpp"

#include <array>
#include <string>
#include <utility>

#include "display/axis_colours.hpp"

namespace crossgrain {
namespace {

Colour colour_of_axis(int axis) {
  return colour_of(kAxisColours[static_cast<std::size_t>(axis)]);
}

}  // namespace

std::vector<Rod> streamlines(const std::vector<AxisCurve>& curves, double radius) {
  std::vector<Rod> rods;
  for (const auto& [points, axis] : curves)
    for (std::size_t i = 1; i < points.size(); ++i)
      rods.push_back({points[i - 1], points[i], radius, colour_of_axis(axis)});
  return rods;
}

std::vector<Rod> streamlines_on(const Section& section, const std::vector<AxisCurve>& curves, double reach,
                                double radius) {
  std::vector<Rod> rods;
  for (const auto& [points, axis] : curves) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      Vector3 from = points[i - 1], to = points[i];
      double above = dot(section.normal, from) - section.offset,
             below = dot(section.normal, to) - section.offset;
      if (above < below) {
        std::swap(above, below);
        std::swap(from, to);
      }
      if (below > reach || above < -reach) continue;
      const Vector3 way = to - from;
      const double drop = above - below;
      const double first = above > reach ? (above - reach) / drop : 0;
      const double last = below < -reach ? (above + reach) / drop : 1;
      const auto on_plane = [&](double share) {
        return from + share * way - (above - share * drop) * section.normal;
      };
      rods.push_back({on_plane(first), on_plane(last), radius, colour_of_axis(axis)});
    }
  }
  return rods;
}

std::optional<LegendBlock> streamline_legend(const std::vector<AxisCurve>& curves) {
  std::array<bool, 3> occurs{};
  for (const AxisCurve& curve : curves) occurs[static_cast<std::size_t>(curve.axis)] = true;
  LegendBlock block{"Streamlines"};
  for (int axis = 0; axis < 3; ++axis) {
    if (!occurs[static_cast<std::size_t>(axis)]) continue;
    block.signs.push_back(
        {Sign::Shape::kThinLine, colour_of_axis(axis), std::string("along axis ") + "xyz"[axis]});
  }
  if (block.signs.empty()) return std::nullopt;
  return block;
}

}  // namespace crossgrain
