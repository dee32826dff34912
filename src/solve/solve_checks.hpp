// SPDX-License-Identifier: Apache-2.0
// Errors that a solve raises before it begins, or if nothing is inside; and its warnings.
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

/// Throws Error(kLimit) if the surface alone needs more memory than allowed, before any is taken for it.
void check_surface_memory(const TriangleMesh& mesh, const SolveOptions& options);

/// Calls `check_scale`. Throws Error(kUsage) if the cells are too large for the model, and Error(kLimit) if
/// even the largest cells that lack of memory permits (kMostLevelsLeftOut) need more memory than allowed.
void check_size(const Surface& surface, const SolveOptions& options);

/// Throws Error(kInput) if no cell has its centre inside and a finer grid would not help: the surface is open
/// or flat. In all processes that share the level.
void check_interior(const GridLevel& finest, const MendedSurface& mended);

/// Returns warnings about details of the surface that the finest cells do not resolve.
std::vector<Warning> resolution_warnings(const SolveReport& report, const Surface& surface,
                                         const SolveOptions& options);
bool is_of_resolution(const Warning& warning);

/// Returns the warning that the cells are larger than requested; report.limited must be set.
Warning memory_warning(const SolveReport& report);

/// Returns the warning that the solve was stopped; report.unfinished must be set.
Warning unfinished_warning(const SolveReport& report);

/// Returns the warning about vertices of a tet mesh outside all cells.
Warning outside_warning(std::size_t outside, std::size_t vertices);

/// Returns a warning if the initial field is of a model of another size or place.
std::optional<Warning> other_model_warning(const Box& earlier, const Box& box);

}  // namespace crossgrain
