// SPDX-License-Identifier: Apache-2.0
// From triangles as a file gives them to a surface that bounds a solid.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/findings.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {

/// A surface that winding numbers can be trusted of, as far as its triangles allow without moving them.
struct MendedSurface {
  Surface surface;
  SurfaceTopology topology;  ///< of the mesh as it was given, its vertices welded
  SurfaceFindings findings;

  /// Every edge of the surface is run along as often in the one direction as in the other, so that winding
  /// numbers are whole.
  bool closed = false;

  /// The closed part that each triangle of the surface belongs to, connected through edges; kNoPart for those
  /// of open parts. Empty where there are fewer than two parts.
  std::vector<std::uint32_t> part_of;
  std::size_t parts = 0;
};

inline constexpr std::uint32_t kNoPart = UINT32_MAX;

/// Triangles without area, duplicates and what bounds nothing are left out; triangles are turned to agree
/// with their neighbours, and patches to look out of the solid; voids stay voids, and parts that overlap stay
/// as they are (patch_sides.hpp). No vertex moves. A mesh that is closed, with all its parts the right way
/// round, or all inside out, comes out as it is.
///
/// Throws Error(kInput) as `prepare_surface` does, and where nothing bounds anything: the message says what
/// the triangles are instead.
MendedSurface mend_surface(CheckedMesh mesh);

}  // namespace crossgrain
