// SPDX-License-Identifier: Apache-2.0
// What a solve refuses before it begins or once it sees that there is nothing to solve, and what it warns of.
#pragma once

#include <optional>
#include <vector>

#include "crossgrain/options.hpp"
#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"
#include "surface/mending.hpp"

namespace crossgrain {

/// Throws Error(kUsage) for an option out of its range.
void check_options(const SolveOptions& options);

/// Throws Error(kInput) for a model so small, large or far away that numbers derived from it leave single
/// precision.
void check_scale(const Box& box);

/// `check_scale`; and throws Error(kUsage) for cells too large for it, Error(kLimit) where even the largest
/// cells that may be taken for want of memory (kMostLevelsLeftOut) would need more than is allowed.
void check_size(const Surface& surface, const SolveOptions& options);

/// Throws Error(kInput) where no cell has its centre inside and that is not for want of resolution: the
/// surface is open, or flat.
void check_interior(const GridLevel& finest, const MendedSurface& mended);

/// Warnings of what the finest cells do not resolve of the surface.
std::vector<Warning> resolution_warnings(const SolveReport& report);
bool is_of_resolution(const Warning& warning);

/// A warning that the cells are larger than was asked for; where report.limited.
Warning memory_warning(const SolveReport& report);

/// A warning that the solve was stopped; where report.unfinished.
Warning unfinished_warning(const SolveReport& report);

/// A warning of vertices of a tet mesh outside every cell.
Warning outside_warning(std::size_t outside, std::size_t vertices);

/// A warning where a field is started from that of a model of another size or place; none otherwise.
std::optional<Warning> other_model_warning(const Box& earlier, const Box& box);

}  // namespace crossgrain
