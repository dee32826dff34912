// SPDX-License-Identifier: Apache-2.0
// Edges of one triangle: holes, and cracks, where open edges run along others.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/edge_uses.hpp"
#include "surface/findings.hpp"

namespace crossgrain {

/// The gap up to which an open edge runs along another one, relative to the longest side of the model: what
/// the tessellations of two CAD faces differ by along their common edge.
inline constexpr double kCrackGap = 1e-3;

/// An open edge and the nearest one that runs along it.
struct CrackSide {
  EdgeUse edge, beside;
  double gap;           ///< from the middle of the edge, model units
  bool same_direction;  ///< of the two triangles along the crack: then one of them is turned
};

struct OpenEdges {
  std::vector<EdgeUse> edges;     ///< in order
  std::vector<CrackSide> cracks;  ///< those of them that run along another, in order
};

/// `uses` are sorted (`sorted_edge_uses`). Gaps up to kCrackGap times `size`.
OpenEdges find_open_edges(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses, double size);

/// Counts holes, sets of open edges that hang together at vertices and are not all crack, and cracks.
void report_open_edges(const std::vector<Vector3>& vertices, const OpenEdges& open,
                       SurfaceFindings& findings);

}  // namespace crossgrain
