// SPDX-License-Identifier: Apache-2.0
// Writes the folder of a field, with additional files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/result_folder.hpp"
#include "files/output_folder.hpp"

namespace crossgrain {

/// Writes files to the folder of a field, and adds to its report.
using AddFiles = std::function<void(OutputFolder& output, SolveReport& report)>;

/// Writes the folder of a result: files by `add_files`, hexahedra, companion and report.json, all or none.
/// `solve` is what all files name (solve_id). `add_first`, unless empty, is called before all else.
SolveReport write_result(SolveReport report, const std::filesystem::path& folder, const Monitor& monitor,
                         const OutputOptions& options, const std::string& solve, const AddFiles& add_files,
                         const AddFiles& add_first = {});

/// Removes those files that a field on tets has, of an earlier result.
void remove_tet_files(OutputFolder& output, SolveReport& report);

/// Like `write_field` (crossgrain/result_folder.hpp), with additional files that appear together with
/// field.vtu and report.json or not at all. `solve` is what all files name (solve_id). add_files creates and
/// writes them; its time counts as seconds.write.
SolveReport write_field_and(const FrameField& field, SolveReport report, const std::filesystem::path& folder,
                            const Monitor& monitor, const OutputOptions& options, const std::string& solve,
                            const AddFiles& add_files);

}  // namespace crossgrain
