// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"
#include "field/kept_forms.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// The forms of up to `options.most` cells of the field merged to `options.merged_cells` cells: cells that
/// hold more than a plane first, then others, evenly chosen in the order of the leaves.
KeptForms kept_forms(const GridLevel& level, const Solid& solid, Degree degree,
                     std::span<const CellConstraint> constraints, const KeptFormOptions& options);

}  // namespace crossgrain
