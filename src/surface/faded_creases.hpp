// SPDX-License-Identifier: Apache-2.0
// Creases that fade out, where a smaller angle would follow them.
#pragma once

#include <optional>
#include <span>

#include "crossgrain/warning.hpp"
#include "surface/crease_angles.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns a warning of long paths of sharp edges that end in the smooth surface, whether they count or not,
/// with the largest angle, a multiple of 5 degrees, that lets most of them end elsewhere or close, found by
/// trying it; empty if none does, such as where creases fade to nothing, or if it brings more edges of other
/// creases. The place is the end of the first. `all_uses` are those of `sorted_edge_uses`.
std::optional<Warning> faded_crease_warning(const Surface& surface, std::span<const EdgeUse> all_uses,
                                            const CreaseAngles& angles);

}  // namespace crossgrain
