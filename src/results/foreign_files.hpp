// SPDX-License-Identifier: Apache-2.0
// Protects the files of a folder that the library has not written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "crossgrain/report.hpp"
#include "crossgrain/result_folder.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Throws Error(kOutput) for a foreign file in a folder, as OutputOptions::foreign_files says, and names it.
/// A folder that does not exist has none.
void check_foreign_files(const std::filesystem::path& folder, const OutputOptions& options);

/// Adds a file without a mark, complete and with a checksum, to the report, by which `check_foreign_files`
/// knows it.
void list_unmarked(const std::string& name, const OutputFile& file, ResultInventory& report);

/// Adds the name of a companion, which may lack a mark, to the report. It has no checksum, because it may
/// contain the report.
void list_companion(const OutputOptions& options, ResultInventory& report);

/// Returns the names of companions that an earlier `write_field` has left in a folder.
std::vector<std::string> companions_in(const std::filesystem::path& folder);

}  // namespace crossgrain
