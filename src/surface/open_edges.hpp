// SPDX-License-Identifier: Apache-2.0
// Edges of one triangle: holes, and cracks, where open edges run along others.
#pragma once

#include <span>
#include <vector>

#include "surface/edge_uses.hpp"
#include "surface/findings.hpp"

namespace crossgrain {

/// Largest gap between open edges of a crack, relative to the longest side of the model: the difference
/// between the tessellations of two CAD faces along their common edge.
inline constexpr double kCrackGap = 1e-3;

/// An open edge and the nearest one that runs along it.
struct CrackSide {
  EdgeUse edge, beside;
  double gap;           ///< distance from the middle of the edge, model units
  bool same_direction;  ///< of the two triangles along the crack: then one of them is flipped
};

struct OpenEdges {
  std::vector<EdgeUse> edges;     ///< sorted
  std::vector<CrackSide> cracks;  ///< edges that run along another one, sorted
};

/// Returns the open edges, with cracks of gaps up to kCrackGap times `size`. `uses` must be sorted
/// (`sorted_edge_uses`).
OpenEdges find_open_edges(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses, double size);

/// Open edges connected at vertices.
struct OpenLoop {
  std::size_t edges = 0;
  std::size_t cracks = 0;  ///< those of its edges that run along another one
  double length = 0;       ///< of all edges, model units
  Vector3 middle{};

  bool is_hole() const { return cracks < edges; }
};

/// Returns the open edges in sets, in the order of their lowest vertices.
std::vector<OpenLoop> open_loops(const std::vector<Vector3>& vertices, const OpenEdges& open);

/// Counts cracks, and holes: sets of open edges connected at vertices that are not only cracks.
void report_open_edges(const std::vector<Vector3>& vertices, const OpenEdges& open,
                       SurfaceFindings& findings);

}  // namespace crossgrain
