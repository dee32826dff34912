// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/monitor.hpp"
#include "crossgrain/result_folder.hpp"
#include "field/field_data.hpp"

namespace crossgrain {

/// Throws Error(kUsage) if the options are invalid: a level out of range, or an empty or invalid box.
void check_output_options(const OutputOptions& options);

/// Returns whether the options select all leaves of a tree unchanged.
bool ask_for_all(const OutputOptions& options, const Octree& tree);

/// Returns the cells that `options` select as a separate field with the report of the whole, and
/// FieldData::merged if they have a level. Its tree has no leaf if no cell meets the box.
///
/// A cell that replaces smaller leaves gets the frame nearest to the volume-weighted mean of their degree-4
/// coefficients; the volume-weighted mean of their energy densities; of the leaves with surface, the mean
/// angle weighted by the areas of their sides, and the class of most of it. It contains surface if a leaf
/// does, and is connected across its faces to whatever a leaf is. No face is open to a cell that is missing.
///
/// Uses 35 bytes per output cell, temporarily half as much again. Throws Error(kInterrupted).
FieldData output_cells(const FieldData& field, const OutputOptions& options, const Monitor& monitor = {});

/// Returns the merged cells of this process, of a field that processes share; `options` have a level, and no
/// box. Cells that several processes have leaves of are given to one of them. All call it together.
FieldData merged_part(const FieldData& part, const OutputOptions& options, const Monitor& monitor);

}  // namespace crossgrain
