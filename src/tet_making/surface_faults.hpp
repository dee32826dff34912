// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crossgrain/warning.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// Throws Error(kInput) if a surface is not closed, naming holes and cracks.
void check_closed(const MendedSurface& mended);

/// Throws Error(kInput) if a surface bounds no solid that can be cut into tets, naming places: it has holes
/// or cracks, or triangles cross.
void check_bounds_solid(const SearchableSurface& surface);

/// Returns what was found in a surface and mended, with triangles that cross, as warnings.
std::vector<Warning> warnings_of_faults(const MendedSurface& mended, const SurfaceFindings& findings);

/// Returns the findings of a surface with those of triangles that cross (find_self_intersections).
SurfaceFindings all_findings(const SearchableSurface& surface);

/// Whether triangles cross, or closed parts overlap or touch.
bool has_crossings(const SurfaceFindings& findings);

/// Whether parts may overlap or touch, which united_surface makes one.
bool may_be_united(const SurfaceFindings& findings);

}  // namespace crossgrain
