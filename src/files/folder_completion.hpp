// SPDX-License-Identifier: Apache-2.0
// Replaces files of a folder one by one, where a folder cannot be exchanged as a whole. One rename inside the
// folder says that the new files are complete; from then on, whoever comes next can bring them to their
// places.
#pragma once

#include <string>

#include "files/folder_exchange.hpp"

namespace crossgrain {

/// Name, in a folder, of the folder of complete new files that are not all in their places.
inline constexpr const char* kCompleteFiles = ".crossgrain-complete";

/// Puts the files of a folder `new_entry`, with its list of replaced names (replaced_names.hpp), into
/// `folder` and removes the other replaced names. Throws Error(kOutput) naming the folder `shown`: with the
/// old files in place, or so that `has_incomplete_files`.
void put_files_in_place(const FolderEntry& new_entry, int folder, const std::string& shown);

bool has_incomplete_files(int folder);

/// Does the rest of an earlier `put_files_in_place` that did not end. The folder must be locked.
void complete_files(int folder, const std::string& shown);

}  // namespace crossgrain
