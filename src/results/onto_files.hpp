// SPDX-License-Identifier: Apache-2.0
// Writes a field on a tet mesh, beside the files of the field on the grid (results/tet_files.hpp).
#pragma once

#include <filesystem>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/result_folder.hpp"
#include "results/tet_writers.hpp"

namespace crossgrain {

/// Like `write_field` (crossgrain/result_folder.hpp), with the files of a field on tets that `options`
/// select: all files or none, and none of another solve.
SolveReport write_field_onto(const FrameField& field, SolveReport report, const TetOutput& output,
                             const std::filesystem::path& folder, const Monitor& monitor = {},
                             const OutputOptions& options = {});

}  // namespace crossgrain
