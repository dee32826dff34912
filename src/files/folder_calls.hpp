// SPDX-License-Identifier: Apache-2.0
// System calls on folders, and the errors of writing.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "files/descriptor.hpp"

namespace crossgrain {

/// Throws Error(kOutput) "NAME: cannot be DOING: ..." for an errno, with its remedy.
[[noreturn]] void fail_output(const std::string& name, const std::string& doing, int code);

/// Opens a folder for listing and for calls relative to it, which go on working if it is moved. Not open,
/// with errno set, if that fails.
Descriptor open_folder(const std::filesystem::path& path);
Descriptor open_folder_in(int folder, const std::string& name);

/// Returns the status of `name` in a folder, without following a link; st_mode is 0, with errno set, if there
/// is none or the system does not tell.
struct stat status_in(int folder, const std::string& name);

/// Returns whether both are known and of one file.
bool is_same_file(const struct stat& a, const struct stat& b);

/// Returns the names of all that is in a folder. Throws Error(kOutput), naming the folder `shown`.
std::vector<std::string> names_in(int folder, const std::string& shown);

/// Brings the names in a folder to the disk. Returns false, with errno set, if that fails; file systems that
/// cannot do so for folders count as done.
bool sync_folder(int folder);

/// Locks a folder for writing until the descriptor is closed or the process ends. Returns false if somebody
/// else has it. File systems without locks (NFS for folders) grant all.
bool try_lock(int folder);

}  // namespace crossgrain
