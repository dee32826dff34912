// SPDX-License-Identifier: Apache-2.0
// What tells results of different solves apart: SolveReport::solve.
#pragma once

#include <filesystem>
#include <string>

#include "crossgrain/result_folder.hpp"
#include "field/field_data.hpp"
#include "results/tet_writers.hpp"

namespace crossgrain {

/// Returns SolveReport::solve of a result: a checksum of all that its files are made of, the same for any
/// number of threads and processes. Processes that share the field call it together; the first has the
/// result. `tets` is null for a field on a grid.
std::string solve_id(const FieldData& data, const OutputOptions& options, const TetOutput* tets = nullptr);

/// The same of hexahedra without a field.
std::string solve_id(const OutputOptions& options);

/// Returns whether a text is one that `solve_id` may return.
bool is_solve_id(const std::string& text);

/// Throws Error(kInput) if a file of a folder that names no solve, as its format has no comments, is not the
/// one that the report lists, as far as its size tells.
void check_listed_sizes(const std::filesystem::path& folder, const ResultInventory& report);

/// Throws Error(kInput) if bytes, read from a file of a folder, are not those that the report lists for it.
void check_listed_bytes(const std::filesystem::path& path, std::string_view bytes,
                        const ResultInventory& report);

}  // namespace crossgrain
