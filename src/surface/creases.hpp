// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a surface, chained into curves between corners.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/options.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// The sharp edges of a surface as curves, in the order of their lowest vertices. A closed curve ends where
/// it begins; it begins at its lowest vertex. Tangents bisect the directions of the edges before and after.
/// Edges of one triangle are not sharp; one of three or more is where any two of them are apart. Vertices
/// must be welded. Edges in `tagged`, pairs of vertices, count as sharp whatever the surface does there.
std::vector<CreaseCurve> sharp_curves(const Surface& surface, const CreaseAngles& angles,
                                      std::span<const std::array<std::uint32_t, 2>> tagged = {});

/// Where curves meet, or where one bends.
struct CreaseCorner {
  Vector3 position;
  std::size_t curves;      ///< that end there; a closed curve that bends at its beginning counts twice
  std::size_t directions;  ///< the same with two that go straight on in each other counted as one
};

/// Ends of three curves and more, and of two that are no continuation of each other, ordered by position.
/// The end of one alone, where a crease fades away, is no corner.
std::vector<CreaseCorner> corners_of(std::span<const CreaseCurve> curves, const CreaseAngles& angles);

/// Edges of two triangles at which there is less than CreaseAngles::knife_deg of solid between them. Normals
/// point out of the solid, or into it where the surface is `inside_out`.
struct KnifeEdges {
  static constexpr std::size_t kMostPlaces = 100;
  std::size_t count = 0;
  std::vector<Vector3> places;  ///< middles of the first kMostPlaces
};
KnifeEdges knife_edges(const Surface& surface, const CreaseAngles& angles, bool inside_out = false);

/// The curves as guides, which end at the corners: tagged ones of their own weight.
Guides guides_along(std::span<const CreaseCurve> curves, std::span<const CreaseCorner> corners, double weight,
                    double tagged_weight = 0);

}  // namespace crossgrain
