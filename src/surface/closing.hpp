// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crossgrain/warning.hpp"
#include "surface/mending.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// Returns a surface mended (mend_surface) and closed, for what needs triangles all around: vertices on open
/// edges that only rounding (kStitchShare) keeps apart, or cracks all over it, are merged, and edges divided
/// at them; then holes are filled (with_filled_holes). Findings are those before holes were filled. Adds the
/// mesh's warnings, and one about vertices that were merged. Throws as mend_surface does.
MendedSurface closed_surface(CheckedMesh mesh, std::vector<Warning>& warnings);

/// Returns the surface around all that a closed one encloses (united_triangles), closed again.
MendedSurface united_surface(const SearchableSurface& surface);

/// Vertices on open edges of a surface are merged if they are at most this far apart, relative to the longest
/// side: what rounding leaves, far below anything modelled.
inline constexpr double kStitchShare = 1e-6;

}  // namespace crossgrain
