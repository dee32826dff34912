// SPDX-License-Identifier: Apache-2.0
#include "page/scene_streamlines.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "solve/tuned_tracer.hpp"

namespace crossgrain {
namespace {

/// Number of seeds of each set, of which those near earlier lines give none.
constexpr std::size_t kSeeds = 120;

/// Least distance between lines along like axes, in longest sides.
constexpr double kSpacing = 1.0 / 18;

/// Largest length of a line in each direction, in longest sides: lines may wind around a part many times and
/// hide it.
constexpr double kSides = 1;

/// Largest number of points of a streamline: tracing takes one point per cell.
constexpr std::size_t kMostPoints = 200;

}  // namespace

StreamlineTracer page_tracer(const FrameField& field) {
  return TunedTracer(field, {.spacing_sides = kSpacing}, {.longest_sides = kSides});
}

StreamlineTracer page_tracer(const TetFrameField& field) {
  return TunedTracer(field, {.spacing_sides = kSpacing}, {.longest_sides = kSides});
}

PageStreamlines::PageStreamlines(const StreamlineTracer& tracer, const Vector3& origin, int axis,
                                 const Monitor& monitor)
    : lines_(origin) {
  add(tracer.trace(tracer.cut_seeds(axis, std::nullopt, kSeeds, monitor), monitor).lines, 0);
  add(tracer.trace(tracer.surface_seeds(kSeeds, monitor), monitor).lines, 1);
}

void PageStreamlines::add(const std::vector<Streamline>& traced, std::uint8_t set) {
  for (const Streamline& line : traced) {
    const std::size_t pieces = line.points.size() - 1;
    const std::size_t drawn = std::min(pieces, kMostPoints);
    for (std::size_t k = 0; k <= drawn; ++k) lines_.add_point(line.points[k * pieces / drawn]);
    lines_.end_line();
    axes_.push_back(static_cast<std::uint8_t>(line.axis));
    sets_.push_back(set);
  }
}

void PageStreamlines::write(SceneWriter& scene) const {
  lines_.write(scene, "streamline_points", "streamline_starts");
  scene.add("streamline_axis", 1, axes_);
  scene.add("streamline_set", 1, sets_);
}

}  // namespace crossgrain
