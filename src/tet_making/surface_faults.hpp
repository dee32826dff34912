// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crossgrain/warning.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// Throws Error(kInput) if a surface bounds no solid that can be cut into tets, naming places: it has holes
/// or cracks, or triangles cross. Returns what was mended, as warnings.
std::vector<Warning> check_bounds_solid(const SearchableSurface& surface);

}  // namespace crossgrain
