// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "remeshing/patched_surface.hpp"

namespace crossgrain {

/// Triangles of a surface that bound one solid: an outer shell and the shells of the voids in it; ascending.
using ClosedBody = std::vector<std::uint32_t>;

/// Returns the bodies of a closed surface, in the order of their first triangles. Shells are sets of
/// triangles connected over edges; those that look into what they enclose are voids, each of the smallest
/// outer shell around it. A void in no shell is a body of its own.
std::vector<ClosedBody> bodies_of(const PatchedSurface& surface);

}  // namespace crossgrain
