// SPDX-License-Identifier: Apache-2.0
// Protects the files of a folder that the library has not written, or that were changed since.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/result_folder.hpp"
#include "files/folder_reservation.hpp"

namespace crossgrain {

/// Throws Error(kOutput) for a foreign or changed file in a folder, as OutputOptions::foreign_files says, and
/// names it. A folder that does not exist has none. Files that were found unchanged are not read again with
/// the same reservation unless somebody has touched them.
void check_foreign_files(const std::filesystem::path& folder, const OutputOptions& options,
                         FolderReservation& reservation, const Monitor& monitor = {});

/// Returns the names of the files in a folder that its report lists; none without a report, or if that was
/// changed.
std::vector<std::string> listed_names_in(const std::filesystem::path& folder);

}  // namespace crossgrain
