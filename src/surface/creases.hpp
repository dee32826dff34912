// SPDX-License-Identifier: Apache-2.0
// Sharp edges of a surface, joined into curves between corners.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/crease_angles.hpp"
#include "surface/edge_uses.hpp"
#include "surface/guides.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the sharp edges of a surface as curves, in the order of their lowest vertices. A closed curve
/// begins and ends at its lowest vertex. Tangents bisect the directions of the edges before and after. Edges
/// of one triangle are not sharp; an edge of three or more is sharp if any two normals differ enough. Edges
/// that fade out count only by CreaseAngles::fading.
/// Vertices must be welded. Edges in `tagged`, pairs of vertices, count as sharp regardless of the surface.
std::vector<CreaseCurve> sharp_curves(const Surface& surface, const CreaseAngles& angles,
                                      std::span<const std::array<std::uint32_t, 2>> tagged = {});

/// Returns the same from known edge uses (`sorted_edge_uses`).
std::vector<CreaseCurve> sharp_curves(const Surface& surface, std::span<const EdgeUse> all_uses,
                                      const CreaseAngles& angles,
                                      std::span<const std::array<std::uint32_t, 2>> tagged = {});

/// Returns the same curves as chains of vertices; a closed one ends with its first vertex. Open ones come
/// first.
std::vector<std::vector<std::uint32_t>> sharp_chains(
    const Surface& surface, std::span<const EdgeUse> all_uses, const CreaseAngles& angles,
    std::span<const std::array<std::uint32_t, 2>> tagged = {});

/// A point where curves meet, or where one bends.
struct CreaseCorner {
  Vector3 position;
  std::size_t curves;      ///< curve ends here; a closed curve that bends at its beginning counts twice
  std::size_t directions;  ///< as `curves`, with two that continue each other counted as one
};

/// Returns the points where three or more curves end, or two that do not continue each other, ordered by
/// position. The end of a single curve, where a crease fades out, is no corner.
std::vector<CreaseCorner> corners_of(std::span<const CreaseCurve> curves);

/// Edges with a smaller angle between their faces, measured inside the solid, are reported as knife edges: no
/// frame is close to both faces.
constexpr double kKnifeDeg = 45;

/// Edges of two triangles with less than kKnifeDeg of solid between them.
struct KnifeEdges {
  static constexpr std::size_t kMostPlaces = 100;
  std::size_t count = 0;
  std::vector<Vector3> places;  ///< middles of the first kMostPlaces
};

/// Returns the knife edges among those of `sorted_edge_uses`. Normals must point out of the solid, or into it
/// if the surface is `inside_out`.
KnifeEdges knife_edges(const Surface& surface, std::span<const EdgeUse> all_uses, bool inside_out = false);

/// Returns the curves as guides that end at the corners; tagged curves have their own weight.
Guides guides_along(std::span<const CreaseCurve> curves, std::span<const CreaseCorner> corners, double weight,
                    double tagged_weight = 0);

}  // namespace crossgrain
