// SPDX-License-Identifier: Apache-2.0
// Repair: from the triangles of a file to a surface that bounds a solid.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/findings.hpp"
#include "surface/open_edges.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {

/// A surface whose winding numbers are reliable, as far as possible without moving vertices.
struct MendedSurface {
  Surface surface;
  SurfaceTopology topology;  ///< of the given mesh with welded vertices
  SurfaceFindings findings;
  std::vector<OpenLoop> open_loops;  ///< around holes and along cracks

  /// Whether triangles run along every edge equally often in both directions, so that winding numbers are
  /// integers.
  bool closed = false;

  /// For each triangle of the surface, the closed part (connected through edges) that it belongs to; kNoPart
  /// if its part is open. Empty if there are fewer than two parts.
  std::vector<std::uint32_t> part_of;
  std::size_t parts = 0;
};

inline constexpr std::uint32_t kNoPart = UINT32_MAX;

/// Leaves out triangles without area, duplicates and sheets that bound nothing. Reorients triangles to agree
/// with their neighbours, and patches to face out of the solid. Voids stay voids, and overlapping parts stay
/// as they are (patch_sides.hpp). No vertex moves. A closed mesh whose parts are all oriented outwards, or
/// all inwards, is returned unchanged.
///
/// Throws Error(kInput) as `prepare_surface` does, and if the triangles enclose nothing; the message says
/// what they are instead.
MendedSurface mend_surface(CheckedMesh mesh);

}  // namespace crossgrain
