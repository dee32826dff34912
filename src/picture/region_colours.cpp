// SPDX-License-Identifier: Apache-2.0
#include "picture/region_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace crossgrain {
namespace {

/// Tones for regions that no line, axis or class has, in the order of region numbers; they repeat.
constexpr std::array<Colour, 10> kRegionColours{
    colour_of(0xc9b48f), colour_of(0x8fb3b5), colour_of(0xb9a3c4), colour_of(0xa9bd8c), colour_of(0xd4a594),
    colour_of(0x8d9dbb), colour_of(0xd9cf8a), colour_of(0x9c8f86), colour_of(0xc9bfd9), colour_of(0x7d9c8c)};

/// Most regions with a line of their own in the legend.
constexpr std::size_t kMostNamed = 10;

}  // namespace

Colour colour_of_region(const std::vector<std::int32_t>& regions, std::int32_t region) {
  const auto place = std::lower_bound(regions.begin(), regions.end(), region) - regions.begin();
  return kRegionColours[static_cast<std::size_t>(place) % kRegionColours.size()];
}

LegendBlock region_legend(const std::vector<std::int32_t>& regions) {
  LegendBlock block{fmt::format("Regions ({})", regions.size())};
  const std::size_t named = regions.size() > kMostNamed ? kMostNamed - 1 : regions.size();
  for (std::size_t i = 0; i < named; ++i)
    block.signs.push_back(
        {Sign::Shape::kBox, colour_of_region(regions, regions[i]), fmt::format("{}", regions[i])});
  if (named < regions.size())
    block.signs.push_back({Sign::Shape::kBox, kRegionColours[named % kRegionColours.size()],
                           fmt::format("and {} more, colours repeat", regions.size() - named)});
  return block;
}

}  // namespace crossgrain
