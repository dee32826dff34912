// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"
#include "field/kept_forms.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Returns the forms of some cells of the field, merged as the page shows it (SolveOptions::for_page). Cells
/// with more than one normal come first, then others; each kind is evenly spaced in the order of the leaves.
/// None of a level that processes share.
KeptForms kept_forms(const GridLevel& level, const Solid& solid, Degree degree,
                     std::span<const CellConstraint> constraints);

}  // namespace crossgrain
