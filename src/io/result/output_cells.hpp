// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/io.hpp"
#include "crossgrain/monitor.hpp"
#include "field/field_data.hpp"

namespace crossgrain {

/// Throws Error(kUsage) where the options make no sense: a level out of range, a box that is empty or no box.
void check_output_options(const OutputOptions& options);

/// Whether these are all leaves of a tree as they are, so that there is nothing to choose.
bool ask_for_all(const OutputOptions& options, const Octree& tree);

/// The cells that `options` ask for, as a field of their own with the report of the whole. Its tree has no
/// leaf where no cell meets the box.
///
/// A cell in place of smaller leaves has the frame nearest to the mean of their coefficients, of degree 4, by
/// volume; the mean of their energy densities by volume; the mean of the angles of those that hold surface,
/// by the areas of their sides, and the class of most of it; holds surface where one of them does; and is
/// joined to what any of them is joined to across its faces. No face is open to a cell that is not there.
///
/// Takes 35 bytes a cell of its own and, at times, half as much again. Throws Error(kInterrupted).
FieldData output_cells(const FieldData& field, const OutputOptions& options, const Monitor& monitor = {});

}  // namespace crossgrain
