// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "surface/patched_surface.hpp"

namespace crossgrain {

/// Triangles of a surface that bound one solid: an outer shell and the shells of the voids in it.
struct ClosedBody {
  std::vector<std::vector<std::uint32_t>> shells;  ///< the outer one first, then the voids; each ascending
};

/// Returns the bodies of a closed surface, in the order of the first triangles of their outer shells. Shells
/// are sets of triangles connected over edges; those that look into what they enclose are voids, each of the
/// smallest outer shell around it. A void in no shell is a body of its own.
std::vector<ClosedBody> bodies_of(const PatchedSurface& surface);

}  // namespace crossgrain
